#include "scenario/load.h"

#include <fmt/core.h>

#include <utility>

#include "base/error.h"
#include "files/input_file.h"
#include "scenario/compose.h"
#include "scenario/read.h"

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
  const Path written_in = directoryOf(origin.file);
  if (origin.kind != Origin::Kind::file || Path(name).is_absolute() || written_in == directory) return name;
  const Path whole = (written_in / name).lexically_normal();
  const Path relative = whole.lexically_relative(directory.lexically_normal());
  return relative.empty() ? std::filesystem::absolute(whole).string() : relative.string();
}

/// Makes the name of an input start from the scenario's directory, in `root` too, and says which file it is.
/// `path`: where the scenario names it; `kind`: what it should be, as "a mesh".
Path resolve(std::string& name, const std::string& path, const char* kind, YamlNode& root,
             const Path& directory) {
  const Origin origin = locate(root, path);
  name = relativeToScenario(name, origin, directory);
  if (YamlNode* written = findNode(root, path)) written->text = name;
  Path file = directory / name;
  try {
    requireInputFile(file, kind);
  } catch (const InputError& error) {
    failAt(origin, fmt::format("{} is \"{}\": {}", path, name, error.text()));
  }
  return file;
}

/// The logs and meshes that the scenario names: shapes and motions with a `file`.
std::vector<Path> resolveInputs(Scenario& scenario, YamlNode& root) {
  std::vector<Path> files;
  const auto add = [&](auto& choice, const std::string& path, const char* kind) {
    const auto addFile = [&](auto& alternative) {
      if constexpr (requires { alternative.file; })
        files.push_back(resolve(alternative.file, path + ".file", kind, root, scenario.directory));
    };
    std::visit(addFile, choice);
  };
  const auto addMesh = [&](SurfaceShape& shape, const std::string& path) {
    add(shape, path + ".shape", "a mesh");
  };
  for (BodySettings& body : scenario.bodies) addMesh(body.shape, "bodies." + body.name);
  for (ToolSettings& tool : scenario.tools) {
    const std::string path = "tools." + tool.name;
    addMesh(tool.shape, path);
    if (tool.clamp && tool.clamp->left_jaw) addMesh(tool.clamp->left_jaw->shape, path + ".clamp.left_jaw");
    for (std::size_t i = 0; tool.clamp && i < tool.clamp->handle.size(); ++i)
      addMesh(tool.clamp->handle[i].shape, path + ".clamp.handle." + std::to_string(i));
    add(tool.motion, path + ".motion", "a log");
  }
  return files;
}

/// " (beside tools.a at scene.yaml:12, force.b at scene.yaml:20)"; nothing for no paths.
std::string writtenAt(const std::vector<std::string>& paths, const YamlNode& root) {
  std::string text;
  for (const std::string& path : paths) {
    std::string place = locate(root, path).beginning();
    if (place.ends_with(": ")) place.resize(place.size() - 2);
    text += (text.empty() ? " (beside " : ", ") + path + (place.empty() ? "" : " at " + place);
  }
  return text.empty() ? text : text + ")";
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
    failAt(locate(tree.root, first.path),
           first.path + " " + first.message + writtenAt(first.others, tree.root));
  }
  const ElasticMaterialKind material = loaded.scenario.bodies.front().elastic.material;
  for (PipelineSettings& pipeline : loaded.scenario.pipelines) pipeline.fillDefaults(material);
  for (BodySettings& body : loaded.scenario.bodies) body.fillDefaults();
  return parsed;
}

}  // namespace

LoadedScenario parseScenario(const std::string& text, const Path& file,
                             const std::vector<Override>& overrides) {
  auto [tree, loaded] = parse(text, file, overrides);
  loaded.inputs = std::move(tree.bases);
  for (Path& input : resolveInputs(loaded.scenario, tree.root)) loaded.inputs.push_back(std::move(input));
  loaded.composed = flowText(tree.root);
  loaded.resolved = toYaml(loaded.scenario);
  return loaded;
}

LoadedScenario parseStoredScenario(const std::string& text, const Path& stored_in) {
  try {
    LoadedScenario loaded = parse(text, "scenario_resolved", {}).loaded;
    loaded.resolved = text;
    return loaded;
  } catch (const InputError& error) {
    throw InputError(inFile(stored_in), std::string("its scenario cannot be read: ") + error.what());
  }
}

LoadedScenario loadScenario(const Path& file, const std::vector<Override>& overrides) {
  LoadedScenario loaded = parseScenario(readYamlFile(file), file, overrides);
  loaded.inputs.insert(loaded.inputs.begin(), file);
  return loaded;
}

}  // namespace fissure
