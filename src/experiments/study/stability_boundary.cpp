#include "study/stability_boundary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "text/scalars.h"

namespace fissure {

std::vector<StabilityBoundary> boundariesOf(std::vector<ClassedPoint> points) {
  std::sort(points.begin(), points.end(), [](const ClassedPoint& a, const ClassedPoint& b) {
    return std::tie(a.others, a.place) < std::tie(b.others, b.place);
  });
  std::vector<StabilityBoundary> found;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ClassedPoint &below = points[i - 1], &above = points[i];
    if (below.others == above.others && below.kind != above.kind)
      found.push_back({below.others, below.place, above.place, below.kind, above.kind});
  }
  return found;
}

std::optional<double> nextPlace(const StabilityBoundary& boundary, double refine_to, bool whole_numbers) {
  const double below = boundary.below, above = boundary.above;
  if (!(above - below > refine_to * std::max(std::abs(below), std::abs(above)))) return std::nullopt;
  const double middle = below > 0 ? std::sqrt(below) * std::sqrt(above) : (below + above) / 2;
  const std::optional<double> place =
      toReal(fmt::format("{:.5g}", whole_numbers ? std::round(middle) : middle));
  if (!place || !(below < *place && *place < above)) return std::nullopt;
  return place;
}

}  // namespace fissure
