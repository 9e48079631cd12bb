#pragma once

#include <string>

#include "main/verbs.h"

namespace fissure {

/// Adds `tradeoff` to `fissure study`.
Verb addTradeoff(Command study, const std::string& command_line);

}  // namespace fissure
