#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scenario/read_map.h"

namespace fissure {

// Readers of values that contain others: maps with a describe(), optional values, lists, arrays and the
// alternatives of a variant. They throw InputError as the readers of plain values do (read_values.h).

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

/// Sets the variant to its alternative number `index`, with default values.
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
void MapReader::tagged(const char* name, std::variant<Ts...>& value, const Key& key) {
  const YamlNode* node = take(name);
  if (!node) {
    if (missing_.empty()) missing_ = name;
    return;
  }
  MapReader io(*node, pathOf(name));
  const YamlNode* type = io.take("type");
  if (!type) failAt(node->origin, "missing key \"type\" in " + pathOf(name) + ", expected it");
  const std::size_t index = readChoice(*type, io.pathOf("type"), *key.table());
  emplaceAlternative(value, index);
  std::visit([&](auto& alternative) { describe(io, alternative); }, value);
  io.finish();
}

}  // namespace fissure
