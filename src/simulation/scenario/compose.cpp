#include "scenario/compose.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include "base/error.h"
#include "files/input_file.h"
#include "text/did_you_mean.h"

namespace fissure {

namespace {

using Kind = YamlNode::Kind;
using Path = std::filesystem::path;

/// The most parts and characters that the path of an override may have: more than any key of a scenario
/// needs.
constexpr std::size_t most_parts = 64, longest_path = 1000;

/// Position of the item that `part` names, or counts; items.size() if there is none.
std::size_t findItem(const std::vector<YamlNode>& items, const std::string& part) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (itemName(items[i]) == part) return i;
  }
  std::size_t index = items.size();
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
  const bool whole = error == std::errc() && end == part.data() + part.size();
  return whole && index < items.size() ? index : items.size();
}

const YamlNode* childAt(const YamlNode& node, const std::string& part) {
  if (node.kind == Kind::map) return node.find(part);
  if (node.kind != Kind::list) return nullptr;
  const std::size_t i = findItem(node.children, part);
  return i < node.children.size() ? &node.children[i] : nullptr;
}

std::vector<std::string> itemNames(const std::vector<YamlNode>& items) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i)
    names.push_back(itemName(items[i]).value_or(std::to_string(i)));
  return names;
}

bool allNamed(const YamlNode& list) {
  return list.kind == Kind::list && !list.children.empty() &&
         std::all_of(list.children.begin(), list.children.end(),
                     [](const YamlNode& item) { return itemName(item).has_value(); });
}

/// Where each name stands; of several of one name, the first.
using Positions = std::map<std::string, std::size_t>;

/// Puts `child` in the place that `positions` has for `name`, or behind the others.
void mergeChild(std::vector<YamlNode>& children, const Positions& positions, const std::string& name,
                YamlNode child) {
  const auto known = positions.find(name);
  if (known == positions.end()) {
    children.push_back(std::move(child));
  } else {
    YamlNode& below = children[known->second];
    below = merge(std::move(below), std::move(child));
  }
}

void mergeItems(YamlNode& base, YamlNode top) {
  Positions positions;
  for (std::size_t i = 0; i < base.children.size(); ++i) positions.emplace(*itemName(base.children[i]), i);
  std::set<std::string> seen;
  for (YamlNode& item : top.children) {
    const std::string name = *itemName(item);
    // Merging would otherwise hide a duplicate: both would go into the same item of the base.
    if (!seen.insert(name).second) {
      failAt(item.origin, "duplicate name \"" + name + "\", expected each name once");
    }
    mergeChild(base.children, positions, name, std::move(item));
  }
}

void mergeEntries(YamlNode& base, YamlNode top) {
  Positions positions;
  for (std::size_t i = 0; i < base.children.size(); ++i) positions.emplace(base.children[i].key, i);
  for (YamlNode& entry : top.children) {
    const std::string key = entry.key;
    mergeChild(base.children, positions, key, std::move(entry));
  }
}

/// A path of an override is copied to all that it makes.
void requireShort(const std::string& path, const std::vector<std::string>& parts) {
  if (path.size() <= longest_path && parts.size() <= most_parts) return;
  failAt(ofOverride(path.substr(0, 40) + "..."),
         fmt::format("a path of {} names in {} bytes, expected at most {} names in {}", parts.size(),
                     path.size(), most_parts, longest_path));
}

bool differentType(const YamlNode& a, const YamlNode& b) {
  const YamlNode* type_a = a.find("type");
  const YamlNode* type_b = b.find("type");
  return type_a && type_b && type_a->text != type_b->text;
}

/// One name for a file however it is reached.
Path identityOf(const Path& file) {
  std::error_code ignored;
  const Path identity = std::filesystem::weakly_canonical(file, ignored);
  return identity.empty() ? file.lexically_normal() : identity;
}

/// `chain`: this file and those that led to it; `bases` grows.
YamlNode composeFile(const std::string& text, const Path& file, std::vector<Path>& chain,
                     std::vector<Path>& bases) {
  YamlNode root = parseYaml(text, inFile(file, 1));
  if (root.kind == Kind::nothing) failAt(inFile(file, 1), "empty, expected a scenario");
  if (root.kind != Kind::map) failAt(root.origin, "not a map, expected `key: value` lines");
  if (const YamlNode* reference = root.find("reference"); reference && root.find("axes"))
    failAt(reference->origin,
           fmt::format("a study (it has a reference), expected a scenario; type: fissure study tradeoff {}",
                       file.string()));
  if (const YamlNode* axes = root.find("axes"); axes && !root.find("bodies") && !root.find("tools"))
    failAt(axes->origin, fmt::format("a sweep (it has axes), expected a scenario; type: fissure sweep {} "
                                     "(with --dry-run it only says what it would run)",
                                     file.string()));
  const YamlNode* base = root.find("base");
  if (!base) return root;
  const Origin origin = base->origin;
  if (base->kind != Kind::scalar || base->text.empty()) failAt(origin, "base is no file name, expected one");
  const Path base_file = file.parent_path() / base->text;
  std::erase_if(root.children, [](const YamlNode& entry) { return entry.key == "base"; });

  const Path identity = identityOf(base_file);
  if (std::find(chain.begin(), chain.end(), identity) != chain.end()) {
    failAt(origin, "base " + base_file.string() + " leads back to itself, expected no cycle of bases");
  }
  try {
    requireInputFile(base_file, "a scenario file");
  } catch (const InputError& error) {
    failAt(origin, "base " + base_file.string() + ": " + error.text());
  }
  bases.push_back(base_file);
  chain.push_back(identity);
  YamlNode below = composeFile(readYamlFile(base_file), base_file, chain, bases);
  chain.pop_back();
  return merge(std::move(below), std::move(root));
}

}  // namespace

ComposedTree compose(const std::string& text, const Path& file) {
  ComposedTree tree;
  std::vector<Path> chain{identityOf(file)};
  tree.root = composeFile(text, file, chain, tree.bases);
  return tree;
}

std::vector<std::string> splitPath(const std::string& path) {
  std::vector<std::string> parts(1);
  for (const char c : path) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::optional<std::string> itemName(const YamlNode& item) {
  if (item.find("quantity")) return std::nullopt;  // an expectation is about a pipeline, not named after it
  for (const char* key : {"name", "pipeline", "model"}) {
    const YamlNode* value = item.find(key);
    if (value && value->kind == Kind::scalar) return value->text;
  }
  return std::nullopt;
}

YamlNode merge(YamlNode base, YamlNode top) {
  if (allNamed(base) && allNamed(top)) {
    base.origin = top.origin;
    mergeItems(base, std::move(top));
    return base;
  }
  if (base.kind != Kind::map || top.kind != Kind::map || differentType(base, top)) return top;
  base.origin = top.origin;
  mergeEntries(base, std::move(top));
  return base;
}

void applyOverride(YamlNode& root, const Override& override) {
  const std::vector<std::string> parts = splitPath(override.path);
  requireShort(override.path, parts);
  const Origin origin = ofOverride(override.path);
  YamlNode value = parseYaml(override.value, origin);
  YamlNode* node = &root;
  std::string walked;
  for (const std::string& part : parts) {
    if (part.empty()) failAt(origin, "an empty name in the path, expected key.key=value");
    if (node->kind == Kind::list) {
      const std::size_t i = findItem(node->children, part);
      if (i == node->children.size()) {
        failAt(origin, fmt::format("{} has no item \"{}\"{}", walked, part,
                                   didYouMean(part, itemNames(node->children))));
      }
      node = &node->children[i];
    } else if (node->kind == Kind::map) {
      if (!node->find(part)) {
        YamlNode entry;
        entry.kind = Kind::map;
        entry.key = part;
        entry.origin = origin;
        node->children.push_back(std::move(entry));
      }
      node = node->find(part);
    } else {
      failAt(origin, fmt::format("{} is a single value, expected it to have an entry \"{}\"", walked, part));
    }
    walked += (walked.empty() ? "" : ".") + part;
  }
  value.key = node->key;
  value.origin = origin;
  *node = std::move(value);
}

YamlNode* findNode(YamlNode& root, const std::string& path) {
  YamlNode* node = &root;
  for (const std::string& part : splitPath(path)) {
    if (node->kind == Kind::list) {
      const std::size_t i = findItem(node->children, part);
      node = i < node->children.size() ? &node->children[i] : nullptr;
    } else {
      node = node->kind == Kind::map ? node->find(part) : nullptr;
    }
    if (!node) break;
  }
  return node;
}

Origin locate(const YamlNode& root, const std::string& path) {
  const YamlNode* node = &root;
  for (const std::string& part : splitPath(path)) {
    const YamlNode* child = childAt(*node, part);
    if (!child) break;
    node = child;
  }
  return node->origin;
}

}  // namespace fissure
