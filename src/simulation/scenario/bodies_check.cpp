#include <string>

#include "scenario/checker.h"

namespace fissure {

namespace {

void checkFixed(Checker check, const FixedRegion& region) {
  check.require(region.below_m.has_value() != region.box.has_value(), "",
                "expected exactly one of below_m and box");
  if (region.box) checkBox(check.in("box"), *region.box);
}

}  // namespace

void checkBox(Checker check, const BoxRegion& box) {
  check.require(!(box.min_m.array() > box.max_m.array()).any(), "min_m",
                "is above max_m, expected at most max_m in each direction");
}

void checkBody(Checker check, const BodySettings& body) {
  checkShape(check.in("shape"), body.shape);
  for (std::size_t i = 0; i < body.fixed.size(); ++i)
    checkFixed(check.in("fixed." + std::to_string(i)), body.fixed[i]);
}

}  // namespace fissure
