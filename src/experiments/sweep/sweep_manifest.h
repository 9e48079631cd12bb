#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "sweep/sweep_file.h"
#include "sweep/sweep_points.h"

namespace fissure {

/// Everything that determines the results of a sweep, stored as manifest.json in its folder.
struct SweepManifest {
  SweepSettings settings;  ///< without `axes` and `exclude`, which are contained in `points`
  std::string scenario;    ///< the base scenario: LoadedScenario::composed
  std::string directory;   ///< folder of its file names, relative to the sweep's folder
  /// Meshes and logs, relative to `directory`, with their hashes.
  std::map<std::string, std::string> inputs;
  /// Those of the inputs that are named by values of axes, not by the base.
  std::set<std::string> axis_inputs;
  std::map<std::string, std::string> engines;  ///< [precision] hash of the worker program
  std::vector<std::string> pipelines;          ///< names of the entries to run
  std::string measured;                        ///< text of the measured file of `settings.fit`, verbatim
  std::vector<CurveQuantity> curves;           ///< the curves that `settings.curves` names
  SweepPoints points;
};

/// Thrown for a manifest that cannot be read.
class DamagedManifest : public InputError {
 public:
  using InputError::InputError;
};

/// `<folder>/manifest.json`.
std::filesystem::path manifestFile(const std::filesystem::path& folder);

/// The manifest as text.
std::string manifestText(const SweepManifest& manifest);

/// Reads the manifest of a folder. Throws InputError when there is none or it is of a newer version,
/// DamagedManifest when it cannot be read.
SweepManifest readManifest(const std::filesystem::path& folder);

}  // namespace fissure
