#include "scenario/read_map.h"

#include <utility>

#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

using Kind = YamlNode::Kind;

}  // namespace

MapReader::MapReader(const YamlNode& node, std::string path) : map_(node), path_(std::move(path)) {
  if (node.kind == Kind::map) return;
  const std::string expected = node.kind == Kind::nothing ? "a map ({} for its defaults)" : "a map";
  wrongNode(node, path_.empty() ? "the document" : path_, expected);
}

void MapReader::read(const YamlNode& node, const std::string& path, std::string& value, const Key& key) {
  if (key.table())
    value = (*key.table())[readChoice(node, path, *key.table())].name;
  else if (key.canBeEmpty())
    readText(node, path, value);
  else
    readValue(node, path, value);
}

std::size_t MapReader::indexIn(const YamlNode& node, const std::string& path, const Key& key) {
  if (!key.expected()) return readChoice(node, path, *key.table());
  std::string name;
  readValue(node, path, name);
  return indexOf(node, path, name, *key.table(), key.expected());
}

void MapReader::finish() const {
  const std::string where = path_.empty() ? "" : " in " + path_;
  for (const YamlNode& entry : map_.children) {
    const bool misplaced = std::any_of(misplaced_.begin(), misplaced_.end(),
                                       [&](const Misplaced& m) { return m.entry == &entry; });
    if (misplaced || std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    failAt(entry.origin, "unknown key " + inQuotes(entry.key) + where + didYouMean(entry.key, known_));
  }
  if (!missing_.empty()) failAt(map_.origin, "missing key " + inQuotes(missing_) + where + ", expected it");
  if (!misplaced_.empty()) {
    const auto& [entry, when] = misplaced_.front();
    failAt(entry->origin,
           "key " + inQuotes(entry->key) + where + " has no meaning here, expected it only for " + when);
  }
}

const YamlNode* MapReader::take(const char* key) {
  known_.emplace_back(key);
  return map_.find(key);
}

std::string MapReader::textOf(const char* key) const {
  const YamlNode* node = map_.find(key);
  return node && node->kind == Kind::scalar ? node->text : std::string();
}

std::string MapReader::pathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void MapReader::noteMisplaced(const char* key, const std::string& when) {
  if (const YamlNode* entry = map_.find(key)) misplaced_.push_back({entry, when});
}

}  // namespace fissure
