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

/// All that fixes what a sweep computes, in one file: manifest.json of its folder.
struct SweepManifest {
  SweepSettings settings;                     ///< `axes` and `exclude` are in `points`, and not kept
  std::string scenario;                       ///< LoadedScenario::composed of the base
  std::string directory;                      ///< where its file names start, from the sweep's folder
  std::map<std::string, std::string> inputs;  ///< meshes and logs, named from `directory`, and their hashes
  std::set<std::string> axis_inputs;          ///< of the inputs: those that values of axes name, not the base
  std::map<std::string, std::string> engines;  ///< hash of the worker program, by its precision
  std::vector<std::string> pipelines;          ///< names of the entries that are run
  std::string measured;                        ///< the file that the settings' fit names, verbatim
  std::vector<CurveQuantity> curves;           ///< what the settings' curves are
  SweepPoints points;
};

/// A plan that cannot be read, of whatever sweep.
class DamagedManifest : public InputError {
 public:
  using InputError::InputError;
};

/// `<folder>/manifest.json`.
std::filesystem::path manifestFile(const std::filesystem::path& folder);

/// The manifest as text.
std::string manifestText(const SweepManifest& manifest);

/// Throws InputError: no such file, of a newer version; DamagedManifest.
SweepManifest readManifest(const std::filesystem::path& folder);

}  // namespace fissure
