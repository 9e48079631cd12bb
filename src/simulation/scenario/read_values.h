#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/catalog.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// Throws InputError: `path is <what the node is>, expected <expected>`.
[[noreturn]] void wrongNode(const YamlNode& node, const std::string& path, const std::string& expected);

// Plain values. Each throws InputError with origin and path when the node is something else or is not finite.
void readValue(const YamlNode& node, const std::string& path, double& value);
void readValue(const YamlNode& node, const std::string& path, int& value);
void readValue(const YamlNode& node, const std::string& path, bool& value);
void readValue(const YamlNode& node, const std::string& path, std::string& value);  ///< not empty
void readValue(const YamlNode& node, const std::string& path, Vec3& value);
/// x, y, z, w; within 1e-6 of unit length, and normalised.
void readValue(const YamlNode& node, const std::string& path, Quat& value);
/// A text that may be empty.
void readText(const YamlNode& node, const std::string& path, std::string& value);

/// Index in `table` of the name that the node holds.
std::size_t readChoice(const YamlNode& node, const std::string& path, const std::vector<CatalogEntry>& table);

/// Index of `name` in `table`. Throws, about the node that holds it, where it is not there.
std::size_t indexOf(const YamlNode& node, const std::string& path, const std::string& name,
                    const std::vector<CatalogEntry>& table, const std::string& expected);
/// The indices of the names that a list holds.
std::vector<std::size_t> readChoices(const YamlNode& node, const std::string& path,
                                     const std::vector<CatalogEntry>& table);

/// Throws unless the node is a list (of `length` items, where given).
void requireList(const YamlNode& node, const std::string& path,
                 std::optional<std::size_t> length = std::nullopt);

/// Path of item `index` of the list at `path`: by its name where it has a good one.
std::string itemPath(const YamlNode& list, const std::string& path, std::size_t index);

}  // namespace fissure
