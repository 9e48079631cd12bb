#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "scenario/load.h"
#include "scene/prepared_scenario.h"

namespace fissure {

/// The changes that the command line makes to the scenarios it names.
struct Selection {
  std::vector<std::string> pipelines;  ///< names of entries to run; empty: all
  /// "path=value".
  std::vector<std::string> overrides;
  bool frames = true;
  bool expectations = true;
};

/// Thrown for surfaces that cannot be simulated. what() has all defects in one line.
class BadSurfaces : public InputError {
 public:
  BadSurfaces(const Origin& origin, const std::string& text, std::vector<std::string> lines)
      : InputError(origin, text), lines_(std::move(lines)) {}
  /// One line per kind of defect, and a line with what was expected.
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

/// A scenario that has passed all checks that are possible without simulating it. Its meshes and logs have
/// been read, each once.
struct CheckedScenario {
  std::filesystem::path file;
  LoadedScenario loaded;   ///< with the selection applied, also in `resolved`
  double duration_s = 0;   ///< recorded time; that of the longest motion where the scenario has none
  std::int64_t steps = 0;  ///< number of recorded steps
  /// Oddities and repairs of surfaces from files, and oddities of logs, one line each: "bodies.liver.shape:
  /// 57 sliver triangles (...)".
  std::vector<std::string> notes;
  PreparedScenario prepared;  ///< with nodes where any of the pipelines uses them
};

/// Loads a scenario, applies `selection`, and makes the checks that need other files: surfaces of bodies,
/// logs of replayed tools, the duration. Meshes are first read in a child process, in case the reader
/// crashes. Throws InputError, and BadSurfaces for surfaces that cannot be simulated.
CheckedScenario checkScenario(const std::filesystem::path& file, const Selection& selection = {});

/// The same for a scenario that is already loaded; `selection.overrides` is ignored. `file` appears in
/// messages.
CheckedScenario checkLoaded(const std::filesystem::path& file, LoadedScenario loaded,
                            const Selection& selection);

}  // namespace fissure
