#include "scenario/checker.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/utf8.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::string is(double value) {
  return "is " + formatReal(value);
}
std::string is(const Vec3& v) {
  return fmt::format("is [{}, {}, {}]", formatReal(v.x()), formatReal(v.y()), formatReal(v.z()));
}

}  // namespace

void Checker::inRange(const std::string& key, double value, const Range& range) {
  require(range.holds(value), key, fmt::format("{}, expected {}", is(value), range.expected()));
}

void Checker::inRange(const std::string& key, const Vec3& value, const Range& range) {
  const bool good = range.holds(value.x()) && range.holds(value.y()) && range.holds(value.z());
  const std::string expected = !range.isLimited()       ? "finite numbers"
                               : range.least_is_outside ? "three numbers above " + formatReal(range.least)
                                                        : "three times " + range.expected();
  require(good, key, fmt::format("{}, expected {}", is(value), expected));
}

void Checker::unit(const std::string& key, const Quat& value) {
  const double norm = value.norm();
  require(std::abs(norm - 1) <= 1e-6, key,
          fmt::format("has length {}, expected a unit quaternion [x, y, z, w]", formatReal(norm)));
}

void Checker::itemName(const std::string& key, const std::string& value) {
  require(isName(value), key, fmt::format("is \"{}\", expected 1 to 64 letters, digits, '_' or '-'", value));
}

void Checker::oneLine(const std::string& key, const std::string& value) {
  require(isPlainLine(value), key, "has line ends or control characters, expected one line of text");
}

bool Checker::itemCount(const std::string& key, std::size_t count, const ItemCount& expected) {
  if (count >= expected.least && count <= expected.most) return true;
  if (count == 0 && expected.least == 1) {
    fail(key, "is empty, expected at least one");
    return false;
  }
  const std::string range = expected.least < 2 ? fmt::format("at most {}", expected.most)
                            : expected.most == any_number
                                ? fmt::format("at least {}", expected.least)
                                : fmt::format("{} to {}", expected.least, expected.most);
  fail(key, fmt::format("has {} items, expected {}", count, range));
  return false;
}

void Checker::oneOf(const std::string& key, const std::string& value,
                    const std::vector<CatalogEntry>& table) {
  std::vector<std::string> names;
  for (const CatalogEntry& entry : table) names.emplace_back(entry.name);
  if (std::find(names.begin(), names.end(), value) != names.end()) return;
  fail(key, fmt::format("is \"{}\"{}", value, didYouMean(value, names)));
}

}  // namespace fissure
