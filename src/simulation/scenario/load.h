#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace fissure {

/// `--set path=value`: `path` as in Problem, list items by name or index; `value` is YAML.
struct Override {
  std::string path;
  std::string value;
};

/// A scenario with what its result must remember.
struct LoadedScenario {
  Scenario scenario;
  std::string source;  ///< the file, verbatim
  /// The file with its bases and overrides merged in, without what it leaves out: a line of YAML that reads
  /// as the file does, from the same directory. Overrides mean the same on top of it; on top of `resolved`
  /// they would not, because defaults are written out there.
  std::string composed;
  std::string resolved;  ///< toYaml(scenario)
  std::vector<std::filesystem::path>
      inputs;  ///< the file, its bases (nearest first), meshes and logs it names
};

/// Reads a scenario file, strictly: unknown or duplicate keys, wrong types, values out of range,
/// octal-looking numbers, non-finite numbers and missing files are InputErrors, one line with file and line,
/// and 'did you mean'. `base: other.yaml`, relative to the file, is read first; this file's keys replace or
/// extend it: maps merge key by key (one with another `type` replaces), lists whose items all have names
/// merge by name, other and empty lists replace. Logs and meshes named in a base start from the base's
/// directory. An override replaces the whole value at its path.
LoadedScenario loadScenario(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// The same from text; `file` is used in messages, and its directory for relative names. It need not exist,
/// and is not among `inputs`.
LoadedScenario parseScenario(const std::string& text, const std::filesystem::path& file,
                             const std::vector<Override>& overrides = {});

/// The scenario that a result or part file carries, from its text. The files it names need not be here any
/// more, and `inputs` is empty. Throws InputError, with `scenario_resolved` for the file.
LoadedScenario parseStoredScenario(const std::string& text);

/// The whole scenario, every default written out, numbers in the shortest form that reads back to the same
/// double. loadScenario of this text gives an equal scenario.
std::string toYaml(const Scenario& scenario);

}  // namespace fissure
