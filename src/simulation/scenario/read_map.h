#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "scenario/key.h"
#include "scenario/read_values.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// Reads one map strictly, so that unknown keys are errors: an Io (scenario/key.h).
class MapReader {
 public:
  /// `path` is the node's path for messages. Throws InputError when the node is no map.
  MapReader(const YamlNode& node, std::string path);

  template <class T>
  void field(const char* name, T& value, const Key& key) {
    if (!key.applies()) return noteMisplaced(name, key.when());
    if (const YamlNode* node = take(name)) return read(*node, pathOf(name), value, key);
    if (key.isRequired() && missing_.empty()) missing_ = name;
    if constexpr (std::is_same_v<T, std::string>)
      if (key.sameAs()) value = textOf(key.sameAs());
  }
  template <class... Ts>
  void tagged(const char* name, std::variant<Ts...>& value, const Key& key);
  template <class Fill>
  void whileReading(Fill fill) {
    fill();
  }

  /// Throws InputError for the first unknown key, else for the first missing one, else for one that does not
  /// apply.
  void finish() const;

 private:
  template <class T>
  static void read(const YamlNode& node, const std::string& path, T& value, const Key& key) {
    if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(indexIn(node, path, key));
    else
      readValue(node, path, value);
  }
  template <class T>
  static void read(const YamlNode& node, const std::string& path, std::optional<T>& value, const Key& key) {
    T one{};
    read(node, path, one, key);
    value = std::move(one);
  }
  template <class T>
  static void read(const YamlNode& node, const std::string& path, std::vector<T>& values, const Key& key) {
    if constexpr (std::is_enum_v<T>) {
      values.clear();
      for (const std::size_t index : readChoices(node, path, *key.table()))
        values.push_back(static_cast<T>(index));
    } else {
      readValue(node, path, values);
    }
  }
  static void read(const YamlNode& node, const std::string& path, std::string& value, const Key& key);
  static std::size_t indexIn(const YamlNode& node, const std::string& path, const Key& key);

  const YamlNode* take(const char* key);
  /// The text of a scalar entry; empty for other entries and where it is missing.
  std::string textOf(const char* key) const;
  std::string pathOf(const std::string& key) const;
  void noteMisplaced(const char* key, const std::string& when);

  const YamlNode& map_;
  std::string path_;
  std::vector<std::string> known_;
  std::string missing_;
  struct Misplaced {
    const YamlNode* entry;
    std::string when;  ///< the condition under which the key is allowed
  };
  std::vector<Misplaced> misplaced_;
};

}  // namespace fissure
