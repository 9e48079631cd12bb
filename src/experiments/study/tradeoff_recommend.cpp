#include "study/tradeoff_recommend.h"

#include <fmt/core.h>

#include "scenario/compose.h"
#include "text/scalars.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// `file` as it is called from `directory`.
std::string calledFrom(const fs::path& directory, const fs::path& file) {
  const fs::path from = fs::weakly_canonical(fs::current_path() / directory);
  return fs::weakly_canonical(fs::current_path() / file).lexically_relative(from).generic_string();
}

/// A key of the scenario; lists of maps with an item a line.
std::string entryText(const YamlNode& entry) {
  if (entry.kind != YamlNode::Kind::list || entry.children.empty())
    return fmt::format("{}: {}\n", entry.key, flowText(entry));
  std::string text = entry.key + ":\n";
  for (const YamlNode& item : entry.children) text += "  - " + flowText(item) + "\n";
  return text;
}

}  // namespace

std::string recommendedText(const fs::path& base, const fs::path& file, const std::string& pipeline,
                            const std::vector<Override>& overrides, const std::vector<std::string>& comment) {
  const fs::path folder = file.parent_path();
  const fs::path written = base.parent_path();
  const LoadedScenario moved = parseScenario("base: " + formatText(calledFrom(folder, base)), file);
  YamlNode root = parseYaml(moved.composed, inFile(file, 1));
  for (const Override& override : overrides) {
    const bool is_file = override.path.ends_with(".file") && fs::path(override.value).is_relative();
    applyOverride(root,
                  is_file ? Override{override.path, calledFrom(folder, written / override.value)} : override);
  }
  std::erase_if(root.children, [](const YamlNode& entry) { return entry.key == "expect"; });
  if (YamlNode* entries = root.find("pipelines"))
    std::erase_if(entries->children, [&](const YamlNode& entry) { return itemName(entry) != pipeline; });
  std::string text;
  for (const std::string& line : comment) text += "# " + line + "\n";
  for (const YamlNode& entry : root.children) text += entryText(entry);
  return text;
}

}  // namespace fissure
