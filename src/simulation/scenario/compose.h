#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenario/load.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// A scenario file with its bases merged in.
struct ComposedTree {
  YamlNode root;                             ///< a map without `base`
  std::vector<std::filesystem::path> bases;  ///< files read beside the first, nearest first
};

/// Parses `text` and reads and merges its `base`, relative to `file`, and so on. Throws InputError with file
/// and line, also for a base that is missing or leads back to a file that names it.
ComposedTree compose(const std::string& text, const std::filesystem::path& file);

/// The names in a path as in Problem: "tools.0.shape" is tools, 0, shape.
std::vector<std::string> splitPath(const std::string& path);

/// What an item of a list is called: its `name`, else its `pipeline` or `model`; nothing for other items.
std::optional<std::string> itemName(const YamlNode& item);

/// `top` over `base`: maps merge key by key, lists whose items all have names merge by name, anything else is
/// replaced: other lists, an empty list, values, and maps with a different `type`.
YamlNode merge(YamlNode base, YamlNode top);

/// Sets one value, creating entries of maps that the file left out (reading finds out whether they exist).
/// Throws InputError that starts with `--set path`,
/// also about a path of more than 64 names or 1000 bytes.
void applyOverride(YamlNode& root, const Override& override);

/// The node at a path as in Problem; null when there is none.
YamlNode* findNode(YamlNode& root, const std::string& path);

/// Where the node at a path as in Problem was written, or the nearest one above it.
Origin locate(const YamlNode& root, const std::string& path);

}  // namespace fissure
