#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenario/key.h"
#include "scenario/load.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// The key by which a scenario file names another one that it extends.
struct CompositionSettings {
  std::optional<std::string> base;
};

template <class Io>
void describe(Io& io, CompositionSettings& c) {
  io.field(
      "base", c.base,
      Key("Scenario file that this one changes, relative to its folder. Maps are merged key by key, lists "
          "whose items all have names item by item; other and empty lists replace.")
          .otherwise("the file is whole by itself"));
}

/// A scenario file with its bases merged in.
struct ComposedTree {
  YamlNode root;                             ///< a map without `base`
  std::vector<std::filesystem::path> bases;  ///< the files that were merged into the first, nearest first
};

/// Parses `text` and merges it over its `base`, a path relative to the folder of `file`, which may have a
/// base itself. Throws InputError with file and line, also for a base that is missing or names, directly or
/// not, a file that it is a base of.
ComposedTree compose(const std::string& text, const std::filesystem::path& file);

/// The names in a path as in Problem: "tools.0.shape" is tools, 0, shape.
std::vector<std::string> splitPath(const std::string& path);

/// The name of an item of a list: its `name`, else its `pipeline` or `model`; no value for other items.
std::optional<std::string> itemName(const YamlNode& item);

/// `top` over `base`: maps merge key by key, lists whose items all have names merge by name, anything else is
/// replaced: other lists, an empty list, values, and maps with a different `type`.
YamlNode merge(YamlNode base, YamlNode top);

/// Sets one value and creates the maps above it that the file leaves out; whether such keys exist is checked
/// when the scenario is read. Throws InputError that begins with `--set path`, also about a path of more than
/// 64 names or 1000 bytes.
void applyOverride(YamlNode& root, const Override& override);

/// The node at a path (written as in Problem); null when there is none.
YamlNode* findNode(YamlNode& root, const std::string& path);

/// The origin of the node at a path (written as in Problem), or of the nearest existing node above it.
Origin locate(const YamlNode& root, const std::string& path);

}  // namespace fissure
