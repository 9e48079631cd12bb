#include "surface/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fissure {

namespace {

double segmentDistanceSquared(const Vec3& from, const Vec3& to, const Vec3& point) {
  const Vec3 along = to - from;
  const double length_squared = along.squaredNorm();
  const double share =
      length_squared > 0 ? std::clamp(along.dot(point - from) / length_squared, 0.0, 1.0) : 0.0;
  return (point - from - share * along).squaredNorm();
}

}  // namespace

double distanceSquared(const TreeTriangle& t, const Vec3& point) {
  const Vec3 u = t.b - t.a;
  const Vec3 v = t.c - t.a;
  const Vec3 w = point - t.a;
  const double uu = u.squaredNorm();
  const double uv = u.dot(v);
  const double vv = v.squaredNorm();
  const double gram = uu * vv - uv * uv;
  const double at_b = vv * u.dot(w) - uv * v.dot(w);  // barycentric coordinates of the foot point, times gram
  const double at_c = uu * v.dot(w) - uv * u.dot(w);
  const double at_a = gram - at_b - at_c;
  // For a sliver the signs are rounding: its edges decide.
  const bool sliver = !(gram > 1e-12 * uu * vv);
  double best = std::numeric_limits<double>::infinity();
  if (gram > 0 && at_a >= 0 && at_b >= 0 && at_c >= 0) {
    best = (w - (at_b / gram) * u - (at_c / gram) * v).squaredNorm();
    if (!sliver) return best;
  }
  // The nearest point lies on an edge beyond which the foot point is.
  if (sliver || at_a < 0) best = std::min(best, segmentDistanceSquared(t.b, t.c, point));
  if (sliver || at_b < 0) best = std::min(best, segmentDistanceSquared(t.c, t.a, point));
  if (sliver || at_c < 0) best = std::min(best, segmentDistanceSquared(t.a, t.b, point));
  return best;
}

double distance_m(const SurfaceTree& tree, const Vec3& point, const DistanceSearch& search) {
  const double limit = search.limit_m * search.limit_m;
  const double enough = search.enough_m >= 0 ? search.enough_m * search.enough_m : -1.0;
  double best = limit;
  bool found = false;
  // A balanced tree over at most 2^31 triangles is less deep than this.
  std::array<std::pair<std::size_t, double>, 64> pending;
  std::size_t waiting = 0;
  pending[waiting++] = {0, tree.boxes()[0].distanceSquared(point)};
  while (waiting > 0) {
    const auto [i, box_distance] = pending[--waiting];
    if (!(box_distance < best)) continue;
    const TreeNode& node = tree.nodes()[i];
    if (node.count == 0) {
      std::pair near{i + 1, tree.boxes()[i + 1].distanceSquared(point)};
      const std::size_t right = static_cast<std::size_t>(tree.nodes()[i + 1].skip);
      std::pair far{right, tree.boxes()[right].distanceSquared(point)};
      if (far.second < near.second) std::swap(near, far);
      if (far.second < best) pending[waiting++] = far;
      if (near.second < best) pending[waiting++] = near;
      continue;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(node.first) + k;
      if (!search.left_out.empty() && search.left_out[index] != 0) continue;
      const double squared = distanceSquared(tree.triangles()[index], point);
      if (!(squared < best)) continue;
      best = squared;
      found = true;
    }
    if (found && best <= enough) break;
  }
  return found ? std::sqrt(best) : std::numeric_limits<double>::infinity();
}

}  // namespace fissure
