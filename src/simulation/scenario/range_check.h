#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/geometry.h"
#include "scenario/checker.h"
#include "scenario/compose.h"
#include "scenario/key.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// Checks each single value of a struct against the description of its key, whether or not the key applies:
/// an Io (scenario/key.h).
class RangeCheck {
 public:
  explicit RangeCheck(Checker check) : check_(std::move(check)) {}

  template <class T>
  void field(const char* name, T& value, const Key& key) {
    check(name, value, key);
  }
  template <class... Ts>
  void tagged(const char* name, std::variant<Ts...>& value, const Key&) {
    std::visit([&](auto& alternative) { checkMap(name, alternative); }, value);
  }
  template <class Fill>
  void whileReading(Fill) {}

 private:
  void check(const std::string& path, double value, const Key& key) {
    check_.inRange(path, value, key.range());
  }
  void check(const std::string& path, int value, const Key& key) { check_.inRange(path, value, key.range()); }
  void check(const std::string& path, Vec3& value, const Key& key) {
    check_.inRange(path, value, key.range());
  }
  void check(const std::string& path, Quat& value, const Key&) { check_.unit(path, value); }
  void check(const std::string& path, std::string& value, const Key& key) {
    if (key.isItemName()) check_.itemName(path, value);
    if (key.table()) check_.oneOf(path, value, *key.table());
    if (key.canBeEmpty()) check_.oneLine(path, value);
  }
  void check(const std::string&, AnyValue&, const Key&) {}
  template <class T>
  void check(const std::string& path, std::optional<T>& value, const Key& key) {
    if (value) check(path, *value, key);
  }
  template <class T, std::size_t N>
  void check(const std::string& path, std::array<T, N>& values, const Key& key) {
    for (T& value : values) check(path, value, key);
  }
  template <class T>
  void check(const std::string& path, std::vector<T>& values, const Key& key) {
    if (!check_.itemCount(path, values.size(), key.items())) return;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < values.size(); ++i)
      check(path + "." + itemPath(values[i], i, seen), values[i], key);
  }
  template <class T>
  void check(const std::string& path, T& value, const Key&) {
    if constexpr (std::is_class_v<T>) checkMap(path, value);
  }

  template <class T>
  void checkMap(const std::string& path, T& value) {
    RangeCheck io(check_.in(path));
    describe(io, value);
  }
  /// An item's name, or its index where the name is no good one or was used before.
  template <class T>
  static std::string itemPath(const T& item, std::size_t index, std::set<std::string>& seen) {
    if constexpr (requires { item.name; })
      if (isName(item.name) && seen.insert(item.name).second) return item.name;
    return std::to_string(index);
  }

  Checker check_;
};

/// Checks every single value of `settings`, a struct with a describe().
template <class T>
void checkRanges(Checker check, T settings) {
  RangeCheck io(std::move(check));
  describe(io, settings);
}

/// Throws InputError about the first value of `settings`, which were read from `root`, that its key does not
/// allow.
template <class T>
void requireRanges(const YamlNode& root, const T& settings) {
  std::vector<Problem> problems;
  checkRanges({problems, ""}, settings);
  if (problems.empty()) return;
  const Problem& first = problems.front();
  failAt(locate(root, first.path), first.path + " " + first.message);
}

}  // namespace fissure
