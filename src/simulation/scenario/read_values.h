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

// Readers of plain values. Each throws InputError with origin and path when the node is of another kind or
// not finite.
void readValue(const YamlNode& node, const std::string& path, double& value);
void readValue(const YamlNode& node, const std::string& path, int& value);
void readValue(const YamlNode& node, const std::string& path, bool& value);
void readValue(const YamlNode& node, const std::string& path, std::string& value);  ///< must not be empty
void readValue(const YamlNode& node, const std::string& path, Vec3& value);
/// Reads x, y, z, w, within 1e-3 of unit length and then normalised, or a map with `axis` and `angle_deg`.
void readValue(const YamlNode& node, const std::string& path, Quat& value);
void readValue(const YamlNode& node, const std::string& path, AnyValue& value);
/// Reads a text that may be empty.
void readText(const YamlNode& node, const std::string& path, std::string& value);

/// Reads a name and returns its index in `table`. Throws InputError where it is not in the table.
std::size_t readChoice(const YamlNode& node, const std::string& path, const std::vector<CatalogEntry>& table);

/// The index of `name` in `table`. Throws InputError about the node where it is not there, with `expected` as
/// the end of the message.
std::size_t indexOf(const YamlNode& node, const std::string& path, const std::string& name,
                    const std::vector<CatalogEntry>& table, const std::string& expected);
/// Reads a list of names and returns their indices in `table`.
std::vector<std::size_t> readChoices(const YamlNode& node, const std::string& path,
                                     const std::vector<CatalogEntry>& table);

/// Throws InputError unless the node is a list, of `length` items where that is given.
void requireList(const YamlNode& node, const std::string& path,
                 std::optional<std::size_t> length = std::nullopt);

/// Path of item `index` of the list at `path`, with its name where it has a valid one, else with its index.
std::string itemPath(const YamlNode& list, const std::string& path, std::size_t index);

}  // namespace fissure
