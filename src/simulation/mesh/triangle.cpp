#include "mesh/triangle.h"

#include <algorithm>
#include <cmath>

namespace fissure {

double relativeHeight(const std::array<Vec3, 3>& corners) {
  const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const double longest_squared =
      std::max({ab.squaredNorm(), ac.squaredNorm(), (corners[2] - corners[1]).squaredNorm()});
  if (longest_squared == 0) return 0;
  const double height = ab.cross(ac).norm() / longest_squared;
  return std::isfinite(longest_squared) ? height : std::nan("");
}

}  // namespace fissure
