#include "surface/winding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

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

/// Signed number of triangles above the point, without triangle `left_out`; none if rounding leaves one of
/// them open.
std::optional<int> countAbove(const SurfaceTree& tree, const Vec3& point, std::size_t left_out) {
  int sum = 0;
  const std::size_t end = tree.nodes().size();
  for (std::size_t i = 0; i < end;) {
    const TreeNode& node = tree.nodes()[i];
    const TreeBox& box = tree.boxes()[i];
    if (point.x() < box.low.x() || point.x() > box.high.x() || point.y() < box.low.y() ||
        point.y() > box.high.y() || point.z() > box.high.z()) {
      i = static_cast<std::size_t>(node.skip);
      continue;
    }
    ++i;
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(node.first) + k;
      if (index == left_out) continue;
      const TreeTriangle& t = tree.triangles()[index];
      const int sign =
          edgeToTheRight(t.a, t.b, point) + edgeToTheRight(t.b, t.c, point) + edgeToTheRight(t.c, t.a, point);
      if (sign == 0) continue;
      const Height height = heightAgainst(t, sign, point);
      if (height == Height::unclear) return std::nullopt;
      if (height == Height::below) sum += sign;
    }
  }
  return sum;
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
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

int nearestInteger(double value) {
  return static_cast<int>(std::lround(value));
}

/// Whether the mean of the corners surely sees every triangle from beneath and is inside once. Then each ray
/// from there meets the surface once (a map of degree 1 to the sphere around it, with no triangle reversed),
/// and every triangle is in order.
bool isStarShaped(const SurfaceTree& tree) {
  Vec3 centre = Vec3::Zero();
  for (const TreeTriangle& t : tree.triangles()) centre += (t.a + t.b + t.c) / 3.0;
  centre /= static_cast<double>(tree.triangles().size());
  const double extent = (tree.boxes()[0].high - tree.boxes()[0].low).maxCoeff();
  const double surely_positive = 1e-12 * extent * extent * extent;
  for (const TreeTriangle& t : tree.triangles()) {
    const double volume = (t.a - centre).dot((t.b - centre).cross(t.c - centre));
    if (!(volume > surely_positive)) return false;
  }
  return windingNumber(tree, centre) == 1;
}

}  // namespace

int windingNumber(const SurfaceTree& tree, const Vec3& point) {
  if (const std::optional<int> count = countAbove(tree, point, kNoTriangle)) return *count;
  return nearestInteger(solidAngleWinding(tree, point, kNoTriangle));
}

int windingBeneath(const SurfaceTree& tree, std::size_t index, const Vec3& point) {
  // Beneath a triangle that faces up, the ray leaves through it; beneath one that faces down, it is behind.
  const int own = tree.triangles()[index].doubleAreaNormal().z() > 0 ? 1 : 0;
  if (const std::optional<int> others = countAbove(tree, point, index)) return *others + own;
  return nearestInteger(solidAngleWinding(tree, point, index) + 0.5);
}

int countInvertedTriangles(const SurfaceTree& tree, std::span<std::uint8_t> buried) {
  std::fill(buried.begin(), buried.end(), std::uint8_t{0});
  if (isStarShaped(tree)) return 0;
  int count = 0;
  for (std::size_t i = 0; i < tree.triangles().size(); ++i) {
    const TreeTriangle& t = tree.triangles()[i];
    if (t.doubleAreaNormal().isZero(0.0)) continue;
    const Vec3 centroid = (t.a + t.b + t.c) / 3.0;
    const auto by = [&](const Vec3& corner) { return Vec3(corner + kFromCorner * (centroid - corner)); };
    bool in_order = true, outside = false;  // outside: on one side of it at least
    for (const Vec3& place : {centroid, by(t.a), by(t.b), by(t.c)}) {
      const int beneath = windingBeneath(tree, i, place);
      in_order = in_order && beneath == 1;
      outside = outside || beneath == 0 || beneath == 1;
      if (!in_order && outside) break;
    }
    if (in_order) continue;
    ++count;
    if (!buried.empty()) buried[i] = outside ? 0 : 1;
  }
  return count;
}

}  // namespace fissure
