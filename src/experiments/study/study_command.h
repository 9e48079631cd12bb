#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/load.h"

namespace fissure {

/// The command that repeats a run of a study into a result of its own, for a shell.
std::string runCommand(const std::filesystem::path& scenario, const std::string& pipeline,
                       const std::vector<Override>& overrides);

}  // namespace fissure
