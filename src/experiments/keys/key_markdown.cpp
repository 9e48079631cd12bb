#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "keys/key_text.h"

namespace fissure {

namespace {

using Kind = KeyNode::Kind;

/// For a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

std::string row(const KeyNode& node) {
  const std::string when = node.when.empty() ? "" : " Only for " + node.when + ".";
  const std::string value = node.kind == Kind::alternative ? "" : cell(valueText(node));
  return fmt::format("| `{}` | {} | {} | {} |\n", node.name, value, cell(node.default_text),
                     cell(node.doc + when));
}

/// What the names of choices mean.
std::string choicesOf(const KeyNode& node) {
  std::string text;
  for (const CatalogEntry& entry : node.choices)
    text.append("  * `").append(entry.name).append("`: ").append(entry.description).append("\n");
  return text;
}

/// The keys of one map as a table and what its choices mean, then the maps in it.
class Markdown {
 public:
  std::string take() { return std::move(text_); }

  void addFile(const KeyNode& file) {
    text_ += fmt::format("\n## {} file\n\n{}", file.name, table(file));
    const std::string prefix = file.name == "scenario" ? "" : file.name + ".";
    for (const KeyNode& child : file.children) addMap(prefix + child.name, child);
  }

 private:
  static std::string table(const KeyNode& map) {
    std::string text = "| key | value | default | what it is |\n|---|---|---|---|\n", choices;
    for (const KeyNode& child : map.children) {
      text += row(child);
      if (child.kind == Kind::choice) choices += "* `" + child.name + "`\n" + choicesOf(child);
    }
    return text + (choices.empty() ? "" : "\n" + choices);
  }

  void addMap(const std::string& path, const KeyNode& node) {
    if (node.children.empty()) return;
    text_ += fmt::format("\n### {}\n\n{}\n\n", path, node.doc);
    if (node.kind == Kind::variant) {
      std::string keys;
      for (const KeyNode& alternative : node.children) keys += table(alternative);
      const auto [same, is_new] = paths_.try_emplace(keys, path);
      text_ += "`type` is one of\n\n" + choicesOf(node);
      if (!is_new) text_ += "\nTheir keys are those of `" + same->second + "`.\n";
      if (!is_new) return;
      for (const KeyNode& alternative : node.children) addMap(path + "." + alternative.name, alternative);
      return;
    }
    const std::string keys = table(node);
    const auto [same, is_new] = paths_.try_emplace(keys, path);
    text_ += is_new ? keys : "Its keys are those of `" + same->second + "`.\n";
    for (const KeyNode& child : node.children)
      if (is_new) addMap(path + "." + child.name, child);
  }

  std::string text_;
  std::map<std::string, std::string> paths_;  ///< of the first map with such a table
};

}  // namespace

std::string keysAsMarkdown() {
  Markdown markdown;
  for (const KeyNode& file : keyFiles()) markdown.addFile(file);
  return "# Keys of scenarios, sweeps, studies and tolerances\n\nMade by `fissure explain --markdown > "
         "configs/KEYS.md` from "
         "the descriptions beside the settings\nin `src`; a test says that it is current. `fissure explain "
         "KEY` "
         "prints one key, `fissure schema` makes editors know\nall of them. Numbers are in SI units, which "
         "the "
         "names of keys end in; the scene's frame has y up.\n" +
         markdown.take();
}

}  // namespace fissure
