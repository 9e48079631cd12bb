#pragma once

#include <algorithm>
#include <array>
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
  void requiredChoice(const char* key, T& value, const std::vector<CatalogEntry>& table) {
    choice(key, value, table);
    if (!map_.find(key) && missing_.empty()) missing_ = key;
  }
  template <class T>
  void choiceIf(bool applies, const char* when, const char* key, T& value,
                const std::vector<CatalogEntry>& table) {
    if (applies) return choice(key, value, table);
    noteMisplaced(key, when);
  }
  void choices(const char* key, std::vector<std::string>& values, const std::vector<CatalogEntry>& table);
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

template <class T>
void readValue(const YamlNode& node, const std::string& path, T& value) {
  MapReader io(node, path);
  describe(io, value);
  io.finish();
}

template <class T>
void readValue(const YamlNode& node, const std::string& path, std::optional<T>& value) {
  T read{};
  readValue(node, path, read);
  value = std::move(read);
}

template <class T>
void readValue(const YamlNode& node, const std::string& path, std::vector<T>& value) {
  requireList(node, path);
  value.clear();
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    T item{};
    readValue(node.children[i], itemPath(node, path, i), item);
    value.push_back(std::move(item));
  }
}

template <class T, std::size_t N>
void readValue(const YamlNode& node, const std::string& path, std::array<T, N>& value) {
  requireList(node, path, N);
  for (std::size_t i = 0; i < N; ++i) readValue(node.children[i], path + "." + std::to_string(i), value[i]);
}

/// Makes the variant hold its alternative number `index`, with defaults.
template <std::size_t I = 0, class... Ts>
void emplaceAlternative(std::variant<Ts...>& value, std::size_t index) {
  if constexpr (I < sizeof...(Ts)) {
    if (index == I) {
      value.template emplace<I>();
    } else {
      emplaceAlternative<I + 1>(value, index);
    }
  }
}

template <class... Ts>
void MapReader::tagged(const char* key, std::variant<Ts...>& value, const std::vector<CatalogEntry>& table) {
  const YamlNode* node = take(key);
  if (!node) {
    if (missing_.empty()) missing_ = key;
    return;
  }
  MapReader io(*node, pathOf(key));
  std::size_t index = 0;
  const YamlNode* type = io.take("type");
  if (!type) failAt(node->origin, "missing key \"type\" in " + pathOf(key) + ", expected it");
  index = readChoice(*type, io.pathOf("type"), table);
  emplaceAlternative(value, index);
  std::visit([&](auto& alternative) { describe(io, alternative); }, value);
  io.finish();
}

}  // namespace fissure
