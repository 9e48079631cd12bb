#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "scenario/load.h"
#include "scene/prepared_scenario.h"
#include "stepping/substep_plan.h"

namespace fissure {

/// What the command line changes about the scenarios it names.
struct Selection {
  std::vector<std::string> pipelines;  ///< names of entries to run; empty: all
  std::vector<std::string> overrides;  ///< "path=value"
  bool frames = true;
  bool expectations = true;
};

/// Surfaces that cannot be simulated: all that is wrong with them. what() says it in one line.
class BadSurfaces : public InputError {
 public:
  BadSurfaces(const Origin& origin, const std::string& text, std::vector<std::string> lines)
      : InputError(origin, text), lines_(std::move(lines)) {}
  /// One per kind of defect, and what was expected.
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

/// A scenario that can be simulated: everything that can be checked without simulating has been. Its meshes
/// and logs have been read, each once.
struct CheckedScenario {
  std::filesystem::path file;
  LoadedScenario loaded;   ///< with the selection applied; `resolved` says so too
  double duration_s = 0;   ///< from time zero, also where the scenario leaves it to its motions
  std::int64_t steps = 0;  ///< recorded ones
  /// What is odd about surfaces from files, what was repaired of them, and what is odd about logs, a line
  /// each: "bodies.liver.shape: 57 sliver triangles (...)".
  std::vector<std::string> notes;
  std::optional<SubstepPlan> substeps;  ///< of the elastic body, where there is one
  PreparedScenario prepared;            ///< with nodes where any of the pipelines uses them
};

/// Loads a scenario, applies `selection`, and checks what needs other files: surfaces of bodies, logs of
/// replayed tools, the duration. Meshes are read apart first. Throws InputError, BadSurfaces.
CheckedScenario checkScenario(const std::filesystem::path& file, const Selection& selection = {});

/// The same for a scenario that is loaded already; `selection.overrides` is not looked at. `file` is used in
/// messages.
CheckedScenario checkLoaded(const std::filesystem::path& file, LoadedScenario loaded,
                            const Selection& selection);

}  // namespace fissure
