#pragma once

#include <variant>

#include "scenario/replay.h"
#include "scenario/script.h"

namespace fissure {

/// The prescribed motion of a tool. The catalog lists the alternatives in this order.
using ToolMotion = std::variant<ScriptMotion, ReplayMotion>;

}  // namespace fissure
