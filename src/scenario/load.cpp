#include "scenario/load.h"

#include <system_error>
#include <utility>

#include "base/error.h"
#include "scenario/compose.h"
#include "scenario/read.h"
#include "scenario/text_file.h"

namespace fissure {

namespace {

using Path = std::filesystem::path;

Path directoryOf(const Path& file) {
  const Path parent = file.parent_path();
  return parent.empty() ? Path(".") : parent;
}

/// A name written in a base file starts from that file's directory; the scenario's names all start from its
/// own.
std::string relativeToScenario(const std::string& name, const Origin& origin, const Path& directory) {
  const Path written_in = directoryOf(origin.source);
  if (origin.line == 0 || Path(name).is_absolute() || written_in == directory) return name;
  const Path whole = (written_in / name).lexically_normal();
  const Path relative = whole.lexically_relative(directory.lexically_normal());
  return relative.empty() ? std::filesystem::absolute(whole).string() : relative.string();
}

/// Makes the logs' names start from the scenario's directory, and says which files they are.
std::vector<Path> resolveLogs(Scenario& scenario, const YamlNode& root) {
  std::vector<Path> logs;
  for (ToolSettings& tool : scenario.tools) {
    auto* replay = std::get_if<ReplayMotion>(&tool.motion);
    if (!replay) continue;
    const std::string path = "tools." + tool.name + ".motion.file";
    const Origin origin = locate(root, path);
    replay->file = relativeToScenario(replay->file, origin, scenario.directory);
    const Path log = scenario.directory / replay->file;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(log, ignored)) {
      failAt(origin, path + " is \"" + replay->file + "\": no such file, expected a log");
    }
    logs.push_back(log);
  }
  return logs;
}

struct Parsed {
  ComposedTree tree;
  LoadedScenario loaded;  ///< without inputs and resolved text
};

Parsed parse(const std::string& text, const Path& file, const std::vector<Override>& overrides) {
  Parsed parsed{compose(text, file), {}};
  auto& [tree, loaded] = parsed;
  for (const Override& override : overrides) applyOverride(tree.root, override);
  loaded.source = text;
  loaded.scenario = readScenario(tree.root);
  loaded.scenario.directory = directoryOf(file);
  const std::vector<Problem> problems = validate(loaded.scenario);
  if (!problems.empty()) {
    const Problem& first = problems.front();
    failAt(locate(tree.root, first.path), first.path + " " + first.message);
  }
  for (PipelineSettings& pipeline : loaded.scenario.pipelines) pipeline.fillDefaults();
  return parsed;
}

}  // namespace

LoadedScenario parseScenario(const std::string& text, const Path& file,
                             const std::vector<Override>& overrides) {
  auto [tree, loaded] = parse(text, file, overrides);
  loaded.inputs = std::move(tree.bases);
  for (Path& log : resolveLogs(loaded.scenario, tree.root)) loaded.inputs.push_back(std::move(log));
  loaded.resolved = toYaml(loaded.scenario);
  return loaded;
}

LoadedScenario parseStoredScenario(const std::string& text) {
  LoadedScenario loaded = parse(text, "scenario_resolved", {}).loaded;
  loaded.resolved = text;
  return loaded;
}

LoadedScenario loadScenario(const Path& file, const std::vector<Override>& overrides) {
  LoadedScenario loaded = parseScenario(readTextFile(file), file, overrides);
  loaded.inputs.insert(loaded.inputs.begin(), file);
  return loaded;
}

}  // namespace fissure
