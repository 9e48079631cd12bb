#include "surface/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fissure {

namespace {

/// From the nearest point of a segment to the point.
Vec3 offsetFromSegment(const Vec3& from, const Vec3& to, const Vec3& point) {
  const Vec3 along = to - from;
  const double length_squared = along.squaredNorm();
  const double share =
      length_squared > 0 ? std::clamp(along.dot(point - from) / length_squared, 0.0, 1.0) : 0.0;
  return point - from - share * along;
}

/// From the nearest point of a triangle to the point.
Vec3 offsetFrom(const TreeTriangle& t, const Vec3& point) {
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
  Vec3 best = Vec3::Constant(std::numeric_limits<double>::infinity());
  double best_squared = std::numeric_limits<double>::infinity();
  if (gram > 0 && at_a >= 0 && at_b >= 0 && at_c >= 0) {
    best = w - (at_b / gram) * u - (at_c / gram) * v;
    if (!sliver) return best;
    best_squared = best.squaredNorm();
  }
  // The nearest point lies on an edge beyond which the foot point is.
  const auto tryEdge = [&](const Vec3& from, const Vec3& to) {
    const Vec3 offset = offsetFromSegment(from, to, point);
    const double squared = offset.squaredNorm();
    if (!(squared < best_squared)) return;
    best = offset;
    best_squared = squared;
  };
  if (sliver || at_a < 0) tryEdge(t.b, t.c);
  if (sliver || at_b < 0) tryEdge(t.c, t.a);
  if (sliver || at_c < 0) tryEdge(t.a, t.b);
  return best;
}

/// Half the extent of a box along a direction of any length, times that length.
double reach(const OrientedBox& box, const Vec3& direction) {
  return (box.axes.transpose() * direction).cwiseAbs().dot(box.half);
}

}  // namespace

double distanceSquared(const TreeTriangle& t, const Vec3& point) {
  return offsetFrom(t, point).squaredNorm();
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

// A triangle lies wholly behind the plane through its point nearest to the centre, across the way from there
// to the centre: what of the box is nearer to it than the centre is measured along that way.
double distanceBound_m(const SurfaceTree& tree, const OrientedBox& box, double limit_m, double near_m,
                       std::vector<std::size_t>& near) {
  near.clear();
  const Vec3 extent = box.axes.cwiseAbs() * box.half;
  const Vec3 low = box.centre - extent, high = box.centre + extent;
  double bound = limit_m;
  const std::size_t end = tree.nodes().size();
  for (std::size_t i = 0; i < end;) {
    const TreeNode& node = tree.nodes()[i];
    const TreeBox& around = tree.boxes()[i];
    const double gap = (around.low - high).cwiseMax(low - around.high).cwiseMax(0.0).squaredNorm();
    const double look_m = std::max({bound, near_m, 0.0});
    if (gap > look_m * look_m) {
      i = static_cast<std::size_t>(node.skip);
      continue;
    }
    ++i;
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(node.first) + k;
      const Vec3 offset = offsetFrom(tree.triangles()[index], box.centre);
      const double distance = offset.norm();
      const double of_triangle = distance > 0 ? distance - reach(box, offset) / distance : -box.half.norm();
      if (of_triangle < near_m && near.size() <= kMostNear) near.push_back(index);
      bound = std::min(bound, of_triangle);
    }
  }
  return bound;
}

}  // namespace fissure
