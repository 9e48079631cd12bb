#include "keys/key_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "text/lists.h"
#include "text/wrapped.h"

namespace fissure {

namespace {

using Kind = KeyNode::Kind;

constexpr std::size_t line_width = 80;

std::string namesOf(const std::vector<CatalogEntry>& choices) {
  std::vector<std::string_view> names;
  for (const CatalogEntry& entry : choices) names.push_back(entry.name);
  return inWords(names, "or");
}

std::string numberText(const KeyNode& node) {
  Range range = node.range;
  if (!range.zero_too) range.reason.clear();  // it is for messages
  std::string text = range.isLimited() ? range.expected() : "a number";
  const std::string number = "a number";
  if (node.kind == Kind::integer && text.starts_with(number))
    text.replace(0, number.size(), "a whole number");
  return text;
}

std::string oneValueText(const KeyNode& node) {
  switch (node.kind) {
    case Kind::number:
    case Kind::integer:
      return numberText(node);
    case Kind::truth:
      return "true or false";
    case Kind::text:
      return node.is_item_name ? "a name" : "a text";
    case Kind::choice:
      return namesOf(node.choices);
    case Kind::any:
      return "a value of any kind";
    case Kind::variant:
      return "a map whose `type` is " + namesOf(node.choices);
    case Kind::map:
    case Kind::alternative:
      break;
  }
  return "a map";
}

std::string countText(const KeyNode& node, std::size_t list) {
  if (node.lists[list] > 0) return " of " + std::to_string(node.lists[list]);
  if (list > 0) return "";
  if (node.items.most < most_items) return fmt::format(" of {} to {}", node.items.least, node.items.most);
  return node.items.least > 0 ? " of at least " + std::to_string(node.items.least) : "";
}

/// To fit a terminal of the usual width.
std::string wrapped(const std::string& text, std::size_t indent) {
  return fissure::wrapped(text, indent, line_width);
}

/// A name in a column of `width`, then a text.
std::string row(const std::string& name, std::size_t width, const std::string& text) {
  return "    " + name + std::string(width - std::min(width, name.size()) + 2, ' ') +
         wrapped(text, width + 6);
}

template <class Items, class NameOf>
std::size_t widest(const Items& items, NameOf nameOf) {
  std::size_t width = 0;
  for (const auto& item : items) width = std::max(width, nameOf(item).size());
  return width;
}

std::string childRows(const std::vector<KeyNode>& nodes, const std::string& prefix = "") {
  const std::size_t width = widest(nodes, [&](const KeyNode& node) { return prefix + node.name; });
  std::string text;
  for (const KeyNode& node : nodes) text += row(prefix + node.name, width, node.doc);
  return text;
}

/// Where the key and what it stands in have a meaning.
std::string whenText(const KeyPlace& key) {
  std::string text;
  for (const KeyNode* node : key.way)
    if (!node->when.empty()) text += (text.empty() ? "" : "; ") + node->when;
  return text;
}

std::string textOf(const KeyPlace& key) {
  const KeyNode& node = *key.node;
  std::string text = key.path + "\n  " + wrapped(node.doc, 2);
  const auto line = [&](const std::string& what, const std::string& value) {
    if (!value.empty()) text += "  " + what + std::string(10 - what.size(), ' ') + wrapped(value, 12);
  };
  if (node.kind != Kind::alternative) {
    line("value", valueText(node));
    line("default", node.default_text);
  }
  line("only for", whenText(key));
  if (node.kind == Kind::choice) {
    text += "  choices\n";
    const std::size_t width = widest(node.choices, [](const CatalogEntry& entry) { return entry.name; });
    for (const CatalogEntry& entry : node.choices)
      text += row(std::string(entry.name), width, std::string(entry.description));
  }
  if (!node.children.empty()) text += node.kind == Kind::variant ? "  types\n" : "  keys\n";
  return text + childRows(node.children);
}

}  // namespace

std::string valueText(const KeyNode& node) {
  std::string text = oneValueText(node);
  for (std::size_t list = node.lists.size(); list-- > 0;)
    text = "a list" + countText(node, list) + ", each " + text;
  if (node.is_rotation) text += ", or a map of `axis` and `angle_deg`";
  return text + (node.unit.empty() || node.unit == "none" ? "" : ", in " + node.unit);
}

std::string topLevelText() {
  std::string text;
  for (const KeyNode& file : keyFiles()) {
    text.append(text.empty() ? "" : "\n").append("Keys of a ").append(file.name).append(" file\n");
    text += childRows(file.children, file.name == "scenario" ? "" : file.name + ".");
  }
  return text + "\nfissure explain KEY says more of one, fissure explain --all everything.\n";
}

std::string textOf(const std::vector<KeyPlace>& keys) {
  std::string text;
  for (const KeyPlace& key : keys) text.append(text.empty() ? "" : "\n").append(textOf(key));
  return text;
}

}  // namespace fissure
