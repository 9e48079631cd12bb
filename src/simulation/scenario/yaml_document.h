#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace fissure {

/// Throws InputError with this origin and message.
[[noreturn]] void failAt(const Origin& origin, const std::string& message);

/// A node of a YAML document as plain data. Anchors, aliases and tags are not supported.
struct YamlNode {
  enum class Kind {
    nothing,  ///< no value, or null
    scalar,
    list,
    map,  ///< keys are unique
  };

  Kind kind = Kind::nothing;
  Origin origin;        ///< origin of the key for an entry of a map, of the value for an item of a list
  std::string key;      ///< key of an entry of a map
  std::string text;     ///< text of a scalar
  bool quoted = false;  ///< the scalar is in quotes or a block, and so never a number or a truth value
  std::vector<YamlNode> children;  ///< items of a list or entries of a map

  /// The entry of a map with this key, or null.
  const YamlNode* find(const std::string& key_wanted) const;
  YamlNode* find(const std::string& key_wanted);
};

/// A value of any kind, as YAML on one line.
struct AnyValue {
  std::string yaml;
};

/// The text of a YAML file: a scenario, a sweep, tolerances. Throws InputError as readTextFile does, and
/// about a file of more than 4 MiB, of size 0 (as in /proc) or in HDF5 format.
std::string readYamlFile(const std::filesystem::path& file);

/// Reads one YAML document; a text without a value gives a node of kind nothing. `first` is the origin of its
/// first line: line 1 of a file, or an override, which is the origin of every line. Throws InputError with
/// the origin for a text that is not UTF-8 or not YAML, and for duplicate keys, more than 10,000 keys in one
/// map, anchors, tags, tabs as indentation and a second document.
YamlNode parseYaml(const std::string& text, const Origin& first);

/// The node on one line, as YAML in flow style that reads back to an equal node.
std::string flowText(const YamlNode& node);

}  // namespace fissure
