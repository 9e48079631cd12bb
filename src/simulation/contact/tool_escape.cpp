#include "contact/tool_escape.h"

#include <algorithm>
#include <limits>

namespace fissure {

namespace {

constexpr int kDoublings = 12;  ///< of a margin: the longest way tried is 4,096 margins
constexpr int kBisections = 6;

/// Does the tool overlap tissue when it stands at `way_m` from where it is?
bool overlaps(std::span<SweptObstacle> obstacles, const Vec3& way_m) {
  return std::any_of(obstacles.begin(), obstacles.end(), [&](SweptObstacle& obstacle) {
    for (std::size_t v = 0; v < obstacle.now_m.size(); ++v) obstacle.now_m[v] = obstacle.before_m[v] - way_m;
    return obstacle.pairs.overlap(obstacle.now_m);
  });
}

/// The length of the shortest way found in one direction; `longest_m` where that is shorter.
double escapeLength_m(std::span<SweptObstacle> obstacles, const Vec3& direction, double longest_m) {
  double length_m = obstacles.front().margin_m;
  for (int i = 0; overlaps(obstacles, length_m * direction); ++i) {
    length_m *= 2;
    if (i == kDoublings || length_m / 2 > longest_m) return longest_m;
  }
  double too_short_m = 0.5 * length_m;
  for (int i = 0; i < kBisections; ++i) {
    const double middle_m = 0.5 * (too_short_m + length_m);
    (overlaps(obstacles, middle_m * direction) ? too_short_m : length_m) = middle_m;
  }
  return std::min(length_m, longest_m);
}

}  // namespace

Vec3 escapeOf(std::span<SweptObstacle> obstacles, const Mat3& scene_axes) {
  Vec3 way_m = Vec3::Zero();
  if (!overlaps(obstacles, way_m)) return way_m;
  double shortest_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    for (const Vec3& along : {Vec3(Vec3::Unit(axis)), Vec3(scene_axes.col(axis))})
      for (const double sign : {1.0, -1.0}) {
        const double length_m = escapeLength_m(obstacles, sign * along, shortest_m);
        if (length_m < shortest_m) way_m = (shortest_m = length_m) * sign * along;
      }
  const Vec3 farther_m = way_m + obstacles.front().margin_m * way_m.stableNormalized();
  return overlaps(obstacles, farther_m) ? way_m : farther_m;
}

}  // namespace fissure
