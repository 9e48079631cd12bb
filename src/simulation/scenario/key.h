#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scenario/catalog.h"

namespace fissure {

// Each key of a file is described in one place. Beside each settings struct stands a template
//
//   template <class Io>
//   void describe(Io& io, TimeSettings& t) {
//     io.field("step_s", t.step_s, Key("Fixed time step of the simulation.").above(0));
//   }
//
// with the keys in the order in which they are written. Code that works on keys is an Io: MapReader,
// MapWriter, RangeCheck (validate() starts with it) and KeyCollector (explain, schema, configs/KEYS.md). An
// Io has these functions:
//   field(name, value, key)    a key with a plain value, a choice, a list or a map that has a describe()
//   tagged(name, value, key)   a variant: a map whose `type` names the alternative
//   whileReading(fill)         sets the defaults of keys that follow by those before

/// The allowed values of a number, or of each number of a list.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_is_outside = false;
  bool zero_too = false;  ///< 0 is allowed too
  std::string reason;     ///< why the least value is the least, or what 0 means; may be empty

  bool holds(double value) const;
  /// Whether it excludes any finite number.
  bool isLimited() const;
  /// The range in words: "a number above 0", "a number from 0 to 1", "a finite number".
  std::string expected() const;
};

/// The largest number of items of a list of maps (bodies, tools, expectations ...), whose items are compared
/// with each other.
inline constexpr std::size_t most_items = 1000;
/// The upper bound for lists of any length.
inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// The allowed numbers of items of a list.
struct ItemCount {
  std::size_t least = 0;
  std::size_t most = any_number;
};

/// The description of one key, for programs and for people. The default value is that of the struct; the
/// functions set everything else and return the key itself. A test checks that every number has a unit and
/// every key a default.
class Key {
 public:
  /// `doc`: whole sentences for a researcher: the meaning, the frame of reference, the consequences.
  explicit Key(const char* doc) : doc_(doc) {}

  /// The unit of a number whose name does not end with one.
  Key& unit(std::string text) { return set(unit_, std::move(text)); }
  Key& noUnit() { return unit("none"); }

  Key& above(double least) { return limit({.least = least, .least_is_outside = true}); }
  Key& above(double least, double most) {
    return limit({.least = least, .most = most, .least_is_outside = true});
  }
  Key& atLeast(double least, const char* reason = "") { return limit({.least = least, .reason = reason}); }
  Key& between(double least, double most) { return limit({.least = least, .most = most}); }
  /// Allows 0 in addition to the range of between().
  Key& orZero(const char* meaning) {
    range_.zero_too = true;
    range_.reason = meaning;
    return *this;
  }
  /// A number without a unit from 0 to 1.
  Key& share() { return noUnit().between(0, 1); }
  /// A whole number without a unit.
  Key& count(double least, double most = std::numeric_limits<double>::infinity()) {
    return noUnit().between(least, most);
  }
  Key& items(std::size_t least, std::size_t most = most_items) { return set(items_, {least, most}); }
  /// The text must be able to name an item: isName().
  Key& itemName() { return set(is_item_name_, true); }
  Key& mayBeEmpty() { return set(may_be_empty_, true); }

  /// The value is a name of this table: for an enum, a text, a list of enums or the alternatives of a
  /// variant.
  Key& oneOf(const std::vector<CatalogEntry>& table) { return set(table_, &table); }
  /// Replaces the list of names at the end of the message about a name that is not in the table.
  Key& expecting(const char* text) { return set(expecting_, text); }

  Key& required(bool is_required = true) { return set(is_required_, is_required); }
  /// The key is an error unless `applies`; `when` completes the message "expected it only for ".
  Key& onlyIf(bool applies, std::string when) {
    applies_ = applies;
    return set(when_, std::move(when));
  }
  /// Describes the default in words, where it is no value of the struct.
  Key& otherwise(std::string text) { return set(otherwise_, std::move(text)); }
  /// States when the struct's value is not the default: "unless `preset` says another".
  Key& except(std::string text) { return set(except_, std::move(text)); }
  /// A name that is optional: its default is the value of this other key.
  Key& sameAs(const char* other_key) { return set(same_as_, other_key); }
  /// The key replaces all other keys of its map.
  Key& alone() { return set(is_alone_, true); }

  const char* doc() const { return doc_; }
  const std::string& unit() const { return unit_; }
  const Range& range() const { return range_; }
  const ItemCount& items() const { return items_; }
  bool isItemName() const { return is_item_name_; }
  bool canBeEmpty() const { return may_be_empty_; }
  const std::vector<CatalogEntry>* table() const { return table_; }
  const char* expected() const { return expecting_; }  ///< null: the message lists the names
  bool isRequired() const { return is_required_; }
  bool applies() const { return applies_; }
  const std::string& when() const { return when_; }
  const std::string& otherwise() const { return otherwise_; }
  const std::string& except() const { return except_; }
  const char* sameAs() const { return same_as_; }  ///< null: no other key is the default
  bool isAlone() const { return is_alone_; }

 private:
  template <class T>
  Key& set(T& field, T value) {
    field = std::move(value);
    return *this;
  }
  Key& limit(Range range) { return set(range_, std::move(range)); }

  const char* doc_;
  std::string unit_;
  Range range_;
  ItemCount items_;
  const std::vector<CatalogEntry>* table_ = nullptr;
  const char* expecting_ = nullptr;
  std::string when_, otherwise_, except_;
  const char* same_as_ = nullptr;
  bool is_item_name_ = false, may_be_empty_ = false, is_required_ = false, applies_ = true, is_alone_ = false;
};

}  // namespace fissure
