#include "motion/monotone_cubic.h"

#include <cmath>

#include "base/reproducible.h"

namespace fissure {

std::vector<Vec3> monotoneSlopes(std::span<const double> times_s, std::span<const Vec3> positions_m) {
  const std::size_t count = positions_m.size();
  std::vector<Vec3> slopes(count, Vec3::Zero());
  if (count < 2) return slopes;
  const auto length = [&](std::size_t i) { return times_s[i + 1] - times_s[i]; };
  const auto secant = [&](std::size_t i) { return Vec3((positions_m[i + 1] - positions_m[i]) / length(i)); };

  slopes.front() = secant(0);
  slopes.back() = secant(count - 2);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Vec3 before = secant(i - 1), after = secant(i);
    const double share = length(i) / (length(i - 1) + length(i));
    for (int axis = 0; axis < 3; ++axis) {
      const bool extremum = before[axis] * after[axis] <= 0;
      slopes[i][axis] = extremum ? 0 : share * before[axis] + (1 - share) * after[axis];
    }
  }
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Vec3 middle = secant(i);
    for (int axis = 0; axis < 3; ++axis) {
      double &from = slopes[i][axis], &to = slopes[i + 1][axis];
      const double steepness = reproducible::hypot(from, to), limit = 3 * std::abs(middle[axis]);
      if (steepness <= limit) continue;
      from *= limit / steepness;
      to *= limit / steepness;
    }
  }
  return slopes;
}

Vec3 hermite(const Vec3& from_m, const Vec3& to_m, const Vec3& slope_from_m_s, const Vec3& slope_to_m_s,
             double length_s, double u) {
  const double rest = 1 - u;
  return (1 + 2 * u) * rest * rest * from_m + u * u * (3 - 2 * u) * to_m +
         length_s * u * rest * (rest * slope_from_m_s - u * slope_to_m_s);
}

}  // namespace fissure
