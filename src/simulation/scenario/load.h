#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace fissure {

/// An override `--set path=value`: `path` as in Problem, with list items by name or index; `value` is YAML.
struct Override {
  std::string path;
  std::string value;
};

/// A scenario with the texts and file names that its result must keep.
struct LoadedScenario {
  Scenario scenario;
  std::string source;  ///< text of the file, verbatim
  /// The file merged with its bases and overrides, without defaults, as one line of YAML: read in the same
  /// directory it gives the same scenario. Further overrides can be applied to it as to the file, which is
  /// not so for `resolved`, where defaults are written out.
  std::string composed;
  std::string resolved;  ///< toYaml(scenario)
  /// The file, its bases (nearest first), and the meshes and logs that it names.
  std::vector<std::filesystem::path> inputs;
};

/// Reads a scenario file, strictly: unknown or duplicate keys, wrong types, values out of range,
/// octal-looking numbers, non-finite numbers and missing files are InputErrors, one line with file and line,
/// and 'did you mean'. `base: other.yaml`, relative to the file, is read first; this file's keys replace or
/// extend it: maps merge key by key (one with another `type` replaces), lists whose items all have names
/// merge by name, other and empty lists replace. Logs and meshes named in a base start from the base's
/// directory. An override replaces the whole value at its path.
LoadedScenario loadScenario(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// The same from a text. `file` appears in messages, and relative names start from its directory; it need not
/// exist and is not among `inputs`.
LoadedScenario parseScenario(const std::string& text, const std::filesystem::path& file,
                             const std::vector<Override>& overrides = {});

/// Reads the text of a scenario that is stored in the result or part file `stored_in`. The files that it
/// names need not exist any more, and `inputs` is empty. Throws InputError about `stored_in`, with the line
/// of the text: "result.h5: its scenario cannot be read: scenario_resolved:11: ...".
LoadedScenario parseStoredScenario(const std::string& text, const std::filesystem::path& stored_in);

/// The whole scenario as YAML, with every default written out and numbers in the shortest form that reads
/// back to the same double. loadScenario of this text gives an equal scenario.
std::string toYaml(const Scenario& scenario);

}  // namespace fissure
