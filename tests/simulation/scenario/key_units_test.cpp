#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "scenario/fields.h"
#include "text/summary_unit.h"

namespace fissure::key_units_test {

namespace {

template <class T>
struct IsList : std::false_type {};
template <class T>
struct IsList<std::optional<T>> : std::true_type {};
template <class T>
struct IsList<std::vector<T>> : std::true_type {};
template <class T, std::size_t N>
struct IsList<std::array<T, N>> : std::true_type {};

/// Collects the keys of all numbers, whether or not they apply: an Io of scenario/fields.h.
class NumberKeys {
 public:
  const std::set<std::string>& keys() const { return keys_; }

  template <class T>
  void field(const char* key, T&) {
    if constexpr (IsList<T>::value) {
      typename T::value_type item{};
      field(key, item);
    } else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double> || std::is_same_v<T, Vec3> ||
                         std::is_same_v<T, Quat>) {
      keys_.insert(key);
    } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
      T map{};
      describe(*this, map);
    }
  }
  template <class T>
  void required(const char* key, T& value) {
    field(key, value);
  }
  template <class T>
  void fieldIf(bool, const char*, const char* key, T& value) {
    field(key, value);
  }
  template <class... Ts>
  void tagged(const char*, std::variant<Ts...>&, const std::vector<CatalogEntry>&) {
    (field("", *std::make_unique<Ts>()), ...);
  }
  template <class T>
  void choice(const char*, T&, const std::vector<CatalogEntry>&) {}
  template <class T>
  void requiredChoice(const char*, T&, const std::vector<CatalogEntry>&, const char* = nullptr) {}
  template <class T>
  void choiceIf(bool, const char*, const char*, T&, const std::vector<CatalogEntry>&) {}
  template <class T>
  void choices(const char*, std::vector<T>&, const std::vector<CatalogEntry>&) {}
  template <class Fill>
  void whileReading(Fill) {}
  void nameOr(const char*, std::string&, const char*) {}
  void text(const char*, std::string&) {}

 private:
  std::set<std::string> keys_;
};

// Words are longer than units.
TEST(KeyUnits, EveryKeyWithAUnitEndingHasOne) {
  NumberKeys io;
  Scenario scenario;
  describe(io, scenario);
  for (const char* key : {"stiffness_N_m", "field_of_view_deg", "size_px", "speed_m_s", "slit_width_m", "k"})
    EXPECT_TRUE(io.keys().contains(key)) << key << " was not walked over";
  const std::set<std::string> words = {"rotate_to"};
  for (const std::string& key : io.keys()) {
    const std::size_t last = key.rfind('_');
    if (last == std::string::npos || key.size() - last > 4 || words.contains(key)) continue;
    EXPECT_NE(summaryUnit(key), "1") << key << ": its ending is not in base/summary_unit.cpp";
  }
}

}  // namespace

}  // namespace fissure::key_units_test
