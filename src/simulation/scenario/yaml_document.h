#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace fissure {

/// Throws InputError with the origin before the message.
[[noreturn]] void failAt(const Origin& origin, const std::string& message);

/// A node of a YAML document as plain data. One way to write each thing: no anchors, no aliases, no tags.
struct YamlNode {
  enum class Kind {
    nothing,  ///< no value written, or null
    scalar,
    list,
    map,  ///< keys are unique
  };

  Kind kind = Kind::nothing;
  Origin origin;        ///< of the key for an entry of a map, of the value for an item of a list
  std::string key;      ///< of an entry of a map
  std::string text;     ///< of a scalar
  bool quoted = false;  ///< of a scalar: written in quotes or as a block, so never a number or a truth value
  std::vector<YamlNode> children;  ///< items of a list, entries of a map

  /// The entry of a map, or null.
  const YamlNode* find(const std::string& key_wanted) const;
  YamlNode* find(const std::string& key_wanted);
};

/// The text of a file that somebody wrote as YAML: a scenario, a sweep, tolerances. Throws InputError as
/// readTextFile does, and about a file of more than 4 MiB or of size 0, as those of /proc are.
std::string readYamlFile(const std::filesystem::path& file);

/// Reads one YAML document; text without a value gives a node of kind nothing. Its first line is at `first`:
/// line 1 of a file, or an override, which stands for every line. Throws InputError with the origin
/// for text that is not UTF-8 or not YAML, and for duplicate keys, more than 10,000 keys in one map,
/// anchors, tags, tabs as indentation and a second document.
YamlNode parseYaml(const std::string& text, const Origin& first);

/// The node on one line, as YAML in flow style that reads back to an equal one.
std::string flowText(const YamlNode& node);

}  // namespace fissure
