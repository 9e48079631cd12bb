#pragma once

#include <string>

#include "main/verbs.h"

namespace fissure {

/// Adds `stability` to `fissure study`.
Verb addStability(Command study, const std::string& command_line);

}  // namespace fissure
