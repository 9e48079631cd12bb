#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scenario/load.h"

namespace fissure {

/// What the command line changes about the scenarios it names.
struct Selection {
  std::vector<std::string> pipelines;  ///< names of entries to run; empty: all
  std::vector<std::string> overrides;  ///< "path=value"
  bool frames = true;
  bool expectations = true;
};

/// A scenario that can be simulated: everything that can be checked without simulating has been.
struct CheckedScenario {
  std::filesystem::path file;
  LoadedScenario loaded;   ///< with the selection applied; `resolved` says so too
  double duration_s = 0;   ///< from time zero, also where the scenario leaves it to its motions
  std::int64_t steps = 0;  ///< recorded ones
};

/// Loads a scenario, applies `selection`, and checks what needs other files: surfaces of bodies, logs of
/// replayed tools, the duration. Throws InputError.
CheckedScenario checkScenario(const std::filesystem::path& file, const Selection& selection = {});

}  // namespace fissure
