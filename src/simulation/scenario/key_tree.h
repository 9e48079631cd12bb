#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/geometry.h"
#include "scenario/key.h"
#include "scenario/yaml_document.h"

namespace fissure {

/// A key of a kind of file with its documentation and the keys below it, from which `explain`, schemas and
/// configs/KEYS.md are made.
struct KeyNode {
  enum class Kind { number, integer, truth, text, choice, any, map, variant, alternative };

  std::string name;
  Kind kind = Kind::map;
  /// The nested lists around the value, outermost first: the fixed length of each, or 0 for any length.
  std::vector<std::size_t> lists;
  std::string doc;
  /// "none" for a number without a unit; empty where none is stated.
  std::string unit;
  std::string default_text;  ///< for people; empty where none is stated
  std::string default_json;  ///< empty where the default is no value
  std::string when;          ///< the condition under which the key is allowed; empty: always
  bool is_required = false;
  bool is_alone = false;  ///< replaces all other keys of its map
  bool is_item_name = false;
  bool can_be_empty = false;
  bool is_rotation = false;  ///< a quaternion, or a map with axis and angle instead
  Range range;
  ItemCount items;  ///< allowed lengths of the outermost list
  std::vector<CatalogEntry> choices;
  /// The keys of a map or an alternative, or the alternatives of a variant, each with its `type` as its name.
  std::vector<KeyNode> children;
};

/// Collects the keys of a struct from its describe(), whether or not they apply: an Io (scenario/key.h).
class KeyCollector {
 public:
  template <class T>
  void field(const char* name, T& value, const Key& key) {
    KeyNode node = nodeOf(name, key);
    fill(node, value);
    add(std::move(node), key);
  }
  template <class... Ts>
  void tagged(const char* name, std::variant<Ts...>&, const Key& key) {
    KeyNode node = nodeOf(name, key);
    node.kind = KeyNode::Kind::variant;
    (addAlternative<Ts>(node), ...);
    add(std::move(node), key);
  }
  template <class Fill>
  void whileReading(Fill) {}

  std::vector<KeyNode> take() { return std::move(nodes_); }

 private:
  using Kind = KeyNode::Kind;

  static KeyNode nodeOf(const char* name, const Key& key);
  /// Appends the node with all that follows from key and value together.
  void add(KeyNode node, const Key& key);

  static void fill(KeyNode& node, double value);
  static void fill(KeyNode& node, int value);
  static void fill(KeyNode& node, bool value);
  static void fill(KeyNode& node, std::string& value);
  static void fill(KeyNode& node, Vec3& value);
  static void fill(KeyNode& node, Quat& value);
  static void fill(KeyNode& node, AnyValue& value);
  template <class T>
  static void fill(KeyNode& node, std::optional<T>& value) {
    if (value) return fill(node, *value);
    T unset{};
    if constexpr (requires { unset.setIdentity(); }) unset.setIdentity();  // Eigen leaves it as it is
    fill(node, unset);
    node.default_json.clear();
  }
  template <class T, std::size_t N>
  static void fill(KeyNode& node, std::array<T, N>& values) {
    fillList(node, values, N);
  }
  template <class T>
  static void fill(KeyNode& node, std::vector<T>&) {
    T item{};
    if constexpr (requires { item.setIdentity(); }) item.setIdentity();
    fill(node, item);
    node.lists.insert(node.lists.begin(), 0);
    node.default_json = "[]";
  }
  template <class T>
  static void fill(KeyNode& node, T& value) {
    if constexpr (std::is_enum_v<T>) {
      fillChoice(node, static_cast<std::size_t>(value));
    } else {
      KeyCollector io;
      describe(io, value);
      node.kind = Kind::map;
      node.children = io.take();
    }
  }
  static void fillChoice(KeyNode& node, std::size_t index);
  template <class List>
  static void fillList(KeyNode& node, List& values, std::size_t length) {
    std::string text;
    for (auto& value : values) {
      node.lists.clear();
      fill(node, value);
      text += (text.empty() ? "" : ", ") + node.default_json;
    }
    node.lists.insert(node.lists.begin(), length);
    node.default_json = "[" + text + "]";
  }
  template <class T>
  static void addAlternative(KeyNode& node) {
    T value{};
    KeyNode& alternative = node.children.emplace_back();
    fill(alternative, value);
    alternative.kind = Kind::alternative;
    alternative.name = std::string(node.choices[node.children.size() - 1].name);
    alternative.doc = std::string(node.choices[node.children.size() - 1].description);
  }

  std::vector<KeyNode> nodes_;
};

/// The keys of a file that is read into `Settings`, as the children of a node of this name.
template <class Settings>
KeyNode keyTree(const char* name) {
  Settings settings;
  KeyCollector io;
  describe(io, settings);
  KeyNode root;
  root.name = name;
  root.children = io.take();
  return root;
}

/// The keys of scenario files.
KeyNode scenarioKeys();

}  // namespace fissure
