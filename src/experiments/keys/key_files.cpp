#include "keys/key_files.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "base/error.h"
#include "scenario/compose.h"
#include "scenario/tolerances.h"
#include "study/stability_file.h"
#include "study/tradeoff_file.h"
#include "sweep/sweep_file.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

void addBelow(const KeyPlace& place, std::vector<KeyPlace>& all) {
  for (const KeyNode& child : place.node->children) {
    KeyPlace below{place.path.empty() ? child.name : place.path + "." + child.name, &child, place.way};
    below.way.push_back(&child);
    all.push_back(below);
    addBelow(below, all);
  }
}

/// Does `wanted`, from its part `part` on, lead along `way` from its node `at` to the end?
bool leads(const std::vector<const KeyNode*>& way, std::size_t at, const std::vector<std::string>& wanted,
           std::size_t part) {
  if (part == wanted.size()) return at == way.size();
  if (at == way.size()) return part + 1 == wanted.size() && !way.back()->lists.empty();  // one of its items
  if (way[at]->name == wanted[part] && leads(way, at + 1, wanted, part + 1)) return true;
  if (way[at]->kind == KeyNode::Kind::alternative && leads(way, at + 1, wanted, part)) return true;
  const bool is_item = at > 0 && !way[at - 1]->lists.empty() && part + 1 < wanted.size();
  return is_item && way[at]->name == wanted[part + 1] && leads(way, at + 1, wanted, part + 2);
}

/// Whether a word of `text` begins with `wanted`, in letters of any case.
bool hasWord(const std::string& text, const std::string& wanted) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  auto from = text.begin();
  while (true) {
    const auto found = std::search(from, text.end(), wanted.begin(), wanted.end(), same);
    if (found == text.end()) return false;
    if (found == text.begin() || !std::isalnum(static_cast<unsigned char>(*(found - 1)))) return true;
    from = found + 1;
  }
}

template <class Fits>
std::vector<KeyPlace> keysThat(Fits fits) {
  std::vector<KeyPlace> found;
  std::copy_if(allKeys().begin(), allKeys().end(), std::back_inserter(found), fits);
  return found;
}

}  // namespace

const std::vector<std::string>& keyFileNames() {
  static const std::vector<std::string> names = {"scenario", "sweep", "stability", "tradeoff", "tolerances"};
  return names;
}

const std::vector<KeyNode>& keyFiles() {
  static const std::vector<KeyNode> files = {scenarioKeys(), sweepKeys(), stabilityKeys(), tradeoffKeys(),
                                             toleranceKeys()};
  return files;
}

const std::vector<KeyPlace>& allKeys() {
  static const std::vector<KeyPlace> all = [] {
    std::vector<KeyPlace> places;
    for (const KeyNode& file : keyFiles())
      addBelow({file.name == "scenario" ? "" : file.name, &file, {}}, places);
    return places;
  }();
  return all;
}

std::vector<KeyPlace> findKeys(const std::string& wanted) {
  std::vector<KeyPlace> found = keysThat([&](const KeyPlace& key) { return key.path == wanted; });
  if (found.empty()) found = keysThat([&](const KeyPlace& key) { return key.path.ends_with("." + wanted); });
  const std::vector<std::string> parts = splitPath(wanted);
  if (found.empty()) found = keysThat([&](const KeyPlace& key) { return leads(key.way, 0, parts, 0); });
  if (found.empty())
    found = keysThat([&](const KeyPlace& key) {
      bool leads_there = false;
      for (std::size_t at = 1; at < key.way.size(); ++at) leads_there |= leads(key.way, at, parts, 0);
      return leads_there;
    });
  if (found.empty() && parts.size() == 1 && wanted.size() >= 3)
    found = keysThat([&](const KeyPlace& key) {
      return hasWord(key.node->name, wanted) || hasWord(key.node->doc, wanted);
    });
  if (!found.empty()) return found;
  // Of a path the nearest path, of a name the nearest name.
  std::set<std::string> known;
  for (const KeyPlace& key : allKeys()) known.insert(parts.size() > 1 ? key.path : key.node->name);
  const std::string nearest = didYouMean(wanted, {known.begin(), known.end()});
  throw InputError(
      {},
      inQuotes(wanted) + " is no key" +
          (nearest.starts_with(", did you mean") ? nearest : ", expected one that fissure explain names"));
}

}  // namespace fissure
