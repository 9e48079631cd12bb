#include "surface/winding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/reproducible.h"

namespace fissure {

namespace {

// How far from a corner, as a share of its way to the centroid, a triangle is looked at. A vertex that came
// out through another sheet by more than about this share of its triangles is found.
constexpr double kFromCorner = 1e-3;

constexpr std::size_t kNoTriangle = std::numeric_limits<std::size_t>::max();

/// Whether the edge from `p` to `q`, seen along z, lies to the right (+x) of the point at its height y: +1 if
/// it goes up there, -1 if down, 0 if not. Depends on the unordered edge but for the sign, bit for bit, so
/// that the sum over the edges of a closed surface is exactly 0 and a ray through an edge or a vertex meets
/// exactly one triangle of those that share it on each sheet. Ties: an edge includes its lower end, a point
/// on the edge has it on its left.
int edgeToTheRight(const Vec3& p, const Vec3& q, const Vec3& point) {
  const bool p_below = p.y() <= point.y();
  const bool q_below = q.y() <= point.y();
  if (p_below == q_below) return 0;
  const Vec3& low = p_below ? p : q;
  const Vec3& high = p_below ? q : p;
  const double side =
      (high.x() - low.x()) * (point.y() - low.y()) - (point.x() - low.x()) * (high.y() - low.y());
  if (!(side > 0)) return 0;
  return p_below ? 1 : -1;
}

enum class Height { below, above, unclear };

/// Where the point is against a triangle that the line through it along z crosses; `sign`: of the triangle's
/// normal's z.
Height heightAgainst(const TreeTriangle& t, int sign, const Vec3& point) {
  if (point.z() < std::min({t.a.z(), t.b.z(), t.c.z()})) return Height::below;
  if (point.z() > std::max({t.a.z(), t.b.z(), t.c.z()})) return Height::above;
  const Vec3 a = t.a - point;
  const Vec3 b = t.b - point;
  const Vec3 c = t.c - point;
  const double volume =
      a.dot(b.cross(c));  // 6 x the tetrahedron; positive: the point is beneath the triangle
  const Vec3 magnitudes = b.cwiseAbs().cross(c.cwiseAbs()) +
                          2 * Vec3(std::abs(b.z() * c.y()), std::abs(b.x() * c.z()), std::abs(b.y() * c.x()));
  // Shewchuk (1997) bounds the rounding error of this determinant by 7.8e-16 times the sum of its terms'
  // magnitudes.
  if (!(std::abs(volume) > 1e-15 * a.cwiseAbs().dot(magnitudes))) return Height::unclear;
  return (volume > 0) == (sign > 0) ? Height::below : Height::above;
}

/// Counts for each point the triangles above it, with their signs and without triangle `left_out`. A point
/// has no value where rounding leaves one of them open. Points that lie together are looked at together.
template <std::size_t N>
std::array<std::optional<int>, N> countAbove(const SurfaceTree& tree, const std::array<Vec3, N>& points,
                                             std::size_t left_out) {
  std::array<std::optional<int>, N> sums;
  sums.fill(0);
  Vec3 low = points[0], high = points[0];
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const std::size_t end = tree.nodes().size();
  for (std::size_t i = 0; i < end;) {
    const TreeNode& node = tree.nodes()[i];
    const TreeBox& box = tree.boxes()[i];
    if (high.x() < box.low.x() || low.x() > box.high.x() || high.y() < box.low.y() ||
        low.y() > box.high.y() || low.z() > box.high.z()) {
      i = static_cast<std::size_t>(node.skip);
      continue;
    }
    ++i;
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(node.first) + k;
      if (index == left_out) continue;
      const TreeTriangle& t = tree.triangles()[index];
      // An edge exactly at a point's x belongs to one of its triangles by rounding: none may be left out
      // there.
      if (std::max({t.a.x(), t.b.x(), t.c.x()}) < low.x() ||
          std::max({t.a.y(), t.b.y(), t.c.y()}) < low.y() ||
          std::min({t.a.y(), t.b.y(), t.c.y()}) > high.y() || std::max({t.a.z(), t.b.z(), t.c.z()}) < low.z())
        continue;
      for (std::size_t p = 0; p < N; ++p) {
        const Vec3& point = points[p];
        const int sign = edgeToTheRight(t.a, t.b, point) + edgeToTheRight(t.b, t.c, point) +
                         edgeToTheRight(t.c, t.a, point);
        if (sign == 0 || !sums[p]) continue;
        const Height height = heightAgainst(t, sign, point);
        if (height == Height::unclear)
          sums[p].reset();
        else if (height == Height::below)
          *sums[p] += sign;
      }
    }
  }
  return sums;
}

/// The winding number as the sum of solid angles over 4 pi (van Oosterom and Strackee 1983), without
/// `left_out`: slow, but it needs no decision about single triangles.
double solidAngleWinding(const SurfaceTree& tree, const Vec3& point, std::size_t left_out) {
  double sum = 0;
  for (std::size_t i = 0; i < tree.triangles().size(); ++i) {
    if (i == left_out) continue;
    const TreeTriangle& t = tree.triangles()[i];
    const Vec3 a = t.a - point;
    const Vec3 b = t.b - point;
    const Vec3 c = t.c - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    sum +=
        reproducible::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

int nearestInteger(double value) {
  return static_cast<int>(std::lround(value));
}

/// The mean of the corners of all triangles.
Vec3 meanOfCorners(const SurfaceTree& tree) {
  Vec3 sum = Vec3::Zero();
  for (const TreeTriangle& t : tree.triangles()) sum += (t.a + t.b + t.c) / 3.0;
  return sum / static_cast<double>(tree.triangles().size());
}

double extentOf(const SurfaceTree& tree) {
  return (tree.boxes()[0].high - tree.boxes()[0].low).maxCoeff();
}

/// Whether the point surely sees every triangle from beneath and is inside once. Then each ray from there
/// meets the surface once (a map of degree 1 to the sphere around it, with no triangle reversed), and every
/// triangle is in order.
bool seesAllFromBeneath(const SurfaceTree& tree, const Vec3& point) {
  const double extent = extentOf(tree);
  const double surely_positive = 1e-12 * extent * extent * extent;
  for (const TreeTriangle& t : tree.triangles()) {
    const double volume = (t.a - point).dot((t.b - point).cross(t.c - point));
    if (!(volume > surely_positive)) return false;
  }
  return windingNumber(tree, point) == 1;
}

/// Moves `point` towards one that sees every triangle from beneath, where there is one: to the far side of
/// the plane that it is farthest on the wrong side of, a few times (Agmon's relaxation, 1954).
void approachStarCentre(const SurfaceTree& tree, Vec3& point) {
  constexpr int most_moves = 16;
  constexpr double too_far = 1.5;  // overshoot, with which the relaxation ends within the planes
  const double margin_m = 1e-3 * extentOf(tree);  // beyond the plane
  for (int move = 0; move < most_moves; ++move) {
    double worst_m = margin_m / 2;
    Vec3 outward = Vec3::Zero();
    for (const TreeTriangle& t : tree.triangles()) {
      const Vec3 normal = t.doubleAreaNormal();
      const double beneath = normal.dot(t.a - point), squared = normal.squaredNorm();
      // Roots are taken only of those that are worse than the worst so far.
      if (worst_m >= 0 ? beneath >= 0 && beneath * beneath >= worst_m * worst_m * squared
                       : beneath >= 0 || beneath * beneath <= worst_m * worst_m * squared)
        continue;
      if (!(squared > 0)) continue;
      worst_m = beneath / std::sqrt(squared);
      outward = normal / std::sqrt(squared);
    }
    if (outward.isZero(0.0)) return;
    point += (too_far * std::min(worst_m, 0.0) - margin_m) * outward;
  }
}

/// Whether some point sees every triangle from beneath. `seen_from` is where the search begins and becomes
/// where it ended; NaN: it begins at the mean of the corners.
bool isStarShaped(const SurfaceTree& tree, Vec3& seen_from) {
  if (!seen_from.allFinite()) seen_from = meanOfCorners(tree);
  if (seesAllFromBeneath(tree, seen_from)) return true;
  approachStarCentre(tree, seen_from);
  return seesAllFromBeneath(tree, seen_from);
}

/// The winding numbers just beneath places on triangle `index`, against its normal: 1 for a triangle of a
/// proper outward surface. In the limit of no distance: no step length enters.
template <std::size_t N>
std::array<int, N> windingsBeneath(const SurfaceTree& tree, std::size_t index,
                                   const std::array<Vec3, N>& places) {
  // Beneath a triangle that faces up, the ray leaves through it; beneath one that faces down, it is behind.
  const int own = tree.triangles()[index].doubleAreaNormal().z() > 0 ? 1 : 0;
  const auto others = countAbove(tree, places, index);
  std::array<int, N> windings = {};
  for (std::size_t p = 0; p < N; ++p)
    windings[p] =
        others[p] ? *others[p] + own : nearestInteger(solidAngleWinding(tree, places[p], index) + 0.5);
  return windings;
}

}  // namespace

int windingNumber(const SurfaceTree& tree, const Vec3& point) {
  if (const std::optional<int> count = countAbove<1>(tree, {point}, kNoTriangle)[0]) return *count;
  return nearestInteger(solidAngleWinding(tree, point, kNoTriangle));
}

int countInvertedTriangles(const SurfaceTree& tree, std::span<std::uint8_t> buried, Vec3* seen_from) {
  std::fill(buried.begin(), buried.end(), std::uint8_t{0});
  Vec3 from = seen_from ? *seen_from : kNowhere;
  const bool in_order = isStarShaped(tree, from);
  if (seen_from) *seen_from = from;
  if (in_order) return 0;
  int count = 0;
  for (std::size_t i = 0; i < tree.triangles().size(); ++i) {
    const TreeTriangle& t = tree.triangles()[i];
    if (t.doubleAreaNormal().isZero(0.0)) continue;
    const Vec3 centroid = (t.a + t.b + t.c) / 3.0;
    const auto by = [&](const Vec3& corner) { return Vec3(corner + kFromCorner * (centroid - corner)); };
    bool proper = true, outside = false;  // outside: on one side of it at least
    for (const int beneath : windingsBeneath<4>(tree, i, {centroid, by(t.a), by(t.b), by(t.c)})) {
      proper = proper && beneath == 1;
      outside = outside || beneath == 0 || beneath == 1;
    }
    if (proper) continue;
    ++count;
    if (!buried.empty()) buried[i] = outside ? 0 : 1;
  }
  return count;
}

}  // namespace fissure
