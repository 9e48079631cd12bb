#include "scenario/checker.h"

#include <algorithm>
#include <cmath>

#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::string is(double value) {
  return "is " + formatReal(value);
}
std::string is(const Vec3& v) {
  return "is [" + formatReal(v.x()) + ", " + formatReal(v.y()) + ", " + formatReal(v.z()) + "]";
}

}  // namespace

void Checker::finite(const std::string& key, double value) {
  require(std::isfinite(value), key, is(value) + ", expected a finite number");
}

void Checker::finite(const std::string& key, const Vec3& value) {
  require(value.allFinite(), key, is(value) + ", expected finite numbers");
}

void Checker::positive(const std::string& key, double value) {
  require(std::isfinite(value) && value > 0, key, is(value) + ", expected a number above 0");
}

void Checker::positive(const std::string& key, const Vec3& value) {
  require(value.allFinite() && (value.array() > 0).all(), key,
          is(value) + ", expected three numbers above 0");
}

void Checker::notNegative(const std::string& key, double value) {
  require(std::isfinite(value) && value >= 0, key, is(value) + ", expected a number of at least 0");
}

void Checker::between(const std::string& key, double value, double low, double high) {
  require(value >= low && value <= high, key,
          is(value) + ", expected a number from " + formatReal(low) + " to " + formatReal(high));
}

void Checker::unit(const std::string& key, const Quat& value) {
  const double norm = value.norm();
  require(std::abs(norm - 1) <= 1e-6, key,
          "has length " + formatReal(norm) + ", expected a unit quaternion [x, y, z, w]");
}

bool tooMany(Checker check, std::size_t count) {
  if (count <= most_items) return false;
  check.fail("", "has " + std::to_string(count) + " items, expected at most " + std::to_string(most_items));
  return true;
}

void Checker::oneOf(const std::string& key, const std::string& value,
                    const std::vector<CatalogEntry>& table) {
  std::vector<std::string> names;
  for (const CatalogEntry& entry : table) names.emplace_back(entry.name);
  if (std::find(names.begin(), names.end(), value) != names.end()) return;
  fail(key, "is \"" + value + "\"" + didYouMean(value, names));
}

}  // namespace fissure
