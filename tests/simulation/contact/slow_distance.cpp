#include "slow_distance.h"

#include <algorithm>
#include <limits>

namespace fissure::test {

namespace {

double fromSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}

/// Over the plane where the foot is inside, else from the border.
double fromTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const auto inside = [&](const Vec3& from, const Vec3& to) {
    return normal.dot((to - from).cross(p - from)) >= 0;
  };
  if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(normal.normalized().dot(p - a));
  return std::min({fromSegment(p, a, b), fromSegment(p, b, c), fromSegment(p, c, a)});
}

/// Of two lines where their feet are inside both segments, else from the four ends.
double betweenSegments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double least =
      std::min({fromSegment(a, c, d), fromSegment(b, c, d), fromSegment(c, a, b), fromSegment(d, a, b)});
  const Vec3 u = b - a, v = d - c, normal = u.cross(v);
  if (normal.norm() < 1e-12 * u.norm() * v.norm()) return least;
  const double s = (c - a).cross(v).dot(normal) / normal.squaredNorm();
  const double t = (c - a).cross(u).dot(normal) / normal.squaredNorm();
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, (a + s * u - c - t * v).norm());
  return least;
}

}  // namespace

double slowDistance_m(const TriangleMesh& one, const TriangleMesh& other) {
  double least = std::numeric_limits<double>::infinity();
  for (const Face& f : one.faces)
    for (const Face& g : other.faces) {
      const std::array<Vec3, 3> a{one.vertices_m[f[0]], one.vertices_m[f[1]], one.vertices_m[f[2]]};
      const std::array<Vec3, 3> b{other.vertices_m[g[0]], other.vertices_m[g[1]], other.vertices_m[g[2]]};
      for (std::size_t i = 0; i < 3; ++i) {
        least = std::min({least, fromTriangle(a[i], b[0], b[1], b[2]), fromTriangle(b[i], a[0], a[1], a[2])});
        for (std::size_t j = 0; j < 3; ++j)
          least = std::min(least, betweenSegments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
      }
    }
  return least;
}

}  // namespace fissure::test
