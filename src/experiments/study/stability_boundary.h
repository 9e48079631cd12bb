#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/stability_class.h"

namespace fissure {

/// A cell whose class is known, at a number of its map's last axis.
struct ClassedPoint {
  std::vector<std::string> others;  ///< values of the other axes
  double place = 0;
  StabilityClass kind = StabilityClass::stable;
};

/// Two neighbours along the last axis, of different classes.
struct StabilityBoundary {
  std::vector<std::string> others;
  double below = 0, above = 0;
  StabilityClass class_below = StabilityClass::stable, class_above = StabilityClass::stable;
};

/// All such neighbours, by the other axes' values and then by place. Points may come in any order.
std::vector<StabilityBoundary> boundariesOf(std::vector<ClassedPoint> points);

/// Where to look next: the geometric mean of both sides, or the arithmetic one where a side is not above 0,
/// in five digits, or the whole number next to it. No value where they differ by at most the share
/// `refine_to` of the larger one, or no such number lies between them.
std::optional<double> nextPlace(const StabilityBoundary& boundary, double refine_to, bool whole_numbers);

}  // namespace fissure
