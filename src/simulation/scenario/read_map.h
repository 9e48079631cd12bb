#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "scenario/catalog.h"
#include "scenario/read_values.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// Reads one map, strictly: the Io of scenario/fields.h. Keys that nobody asked for are errors.
class MapReader {
 public:
  /// Throws InputError when the node is no map.
  MapReader(const YamlNode& node, std::string path);

  template <class T>
  void field(const char* key, T& value) {
    if (const YamlNode* node = take(key)) readValue(*node, pathOf(key), value);
  }
  template <class T>
  void required(const char* key, T& value) {
    field(key, value);
    if (!map_.find(key) && missing_.empty()) missing_ = key;
  }
  template <class T>
  void fieldIf(bool applies, const char* when, const char* key, T& value) {
    if (applies) return field(key, value);
    noteMisplaced(key, when);
  }
  template <class T>
  void choice(const char* key, T& value, const std::vector<CatalogEntry>& table) {
    const YamlNode* node = take(key);
    if (!node) return;
    const std::size_t index = readChoice(*node, pathOf(key), table);
    if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(index);
    } else {
      value = table[index].name;
    }
  }
  template <class T>
  void choice(const char* key, std::optional<T>& value, const std::vector<CatalogEntry>& table) {
    T chosen{};
    choice(key, chosen, table);
    if (map_.find(key)) value = std::move(chosen);
  }
  template <class T>
  void requiredChoice(const char* key, T& value, const std::vector<CatalogEntry>& table) {
    choice(key, value, table);
    if (!map_.find(key) && missing_.empty()) missing_ = key;
  }
  /// `expected` stands in the message about a text that is no name of the table.
  template <class Enum>
  void requiredChoice(const char* key, Enum& value, const std::vector<CatalogEntry>& table,
                      const char* expected) {
    std::string name;
    required(key, name);
    const YamlNode* node = map_.find(key);
    if (node) value = static_cast<Enum>(indexOf(*node, pathOf(key), name, table, expected));
  }
  template <class T>
  void choiceIf(bool applies, const char* when, const char* key, T& value,
                const std::vector<CatalogEntry>& table) {
    if (applies) return choice(key, value, table);
    noteMisplaced(key, when);
  }
  template <class Enum>
  void choices(const char* key, std::vector<Enum>& values, const std::vector<CatalogEntry>& table) {
    const YamlNode* node = take(key);
    if (!node) return;
    values.clear();
    for (const std::size_t index : readChoices(*node, pathOf(key), table))
      values.push_back(static_cast<Enum>(index));
  }
  template <class... Ts>
  void tagged(const char* key, std::variant<Ts...>& value, const std::vector<CatalogEntry>& table);
  template <class Fill>
  void whileReading(Fill fill) {
    fill();
  }
  void nameOr(const char* key, std::string& value, const char* other_key);
  void text(const char* key, std::string& value);

  /// Throws InputError for the first unknown key, else for the first missing one, else for one without a
  /// meaning here.
  void finish() const;

 private:
  const YamlNode* take(const char* key);
  std::string pathOf(const std::string& key) const;
  void noteMisplaced(const char* key, const char* when);

  const YamlNode& map_;
  std::string path_;
  std::vector<std::string> known_;
  std::string missing_;
  struct Misplaced {
    const YamlNode* entry;
    std::string when;  ///< where the key would have a meaning
  };
  std::vector<Misplaced> misplaced_;
};

}  // namespace fissure
