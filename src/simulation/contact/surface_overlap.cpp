#include <algorithm>
#include <cmath>

#include "base/reproducible.h"
#include "contact/swept_pairs.h"

namespace fissure {

namespace {

/// Does segment pq cross the triangle abc?
bool crosses(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& abc) {
  const auto side = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
  };
  const auto& [a, b, c] = abc;
  if ((side(a, b, c, p) > 0) == (side(a, b, c, q) > 0)) return false;
  const bool first = side(p, q, a, b) > 0;
  return first == (side(p, q, b, c) > 0) && first == (side(p, q, c, a) > 0);
}

/// How often a closed surface goes round a point: 0 outside.
double windingNumber(const Vec3& point_m, std::span<const Vec3> vertices_m, const std::vector<Face>& faces) {
  double angle = 0;
  for (const Face& face : faces) {
    const Vec3 a = vertices_m[face[0]] - point_m, b = vertices_m[face[1]] - point_m,
               c = vertices_m[face[2]] - point_m;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle +=
        reproducible::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (2 * M_PI);
}

}  // namespace

bool SweptPairs::overlap(std::span<const Vec3> at_m) {
  const auto holds = [](const SurfaceFeatures& surface, std::span<const Vec3> vertices_m,
                        const Vec3& point_m) {
    return std::abs(windingNumber(point_m, vertices_m, surface.faces())) > 0.5;
  };
  gather({at_m, at_m}, 0);
  for (const FacePair& pair : face_pairs_) {
    const Face &mine = body_.faces()[pair.tissue], &other = tool_.faces()[pair.tool];
    const std::array<Vec3, 3> a{at_m[mine[0]], at_m[mine[1]], at_m[mine[2]]};
    const std::array<Vec3, 3> b{corners_m_[other[0]], corners_m_[other[1]], corners_m_[other[2]]};
    for (std::size_t i = 0; i < 3; ++i)
      if (crosses(a[i], a[(i + 1) % 3], b) || crosses(b[i], b[(i + 1) % 3], a)) return true;
  }
  const auto holdsAny = [&](const SurfaceFeatures& outer, std::span<const Vec3> vertices_m,
                            const SurfaceFeatures& inner, std::span<const Vec3> points_m) {
    return std::any_of(inner.shells().begin(), inner.shells().end(),
                       [&](int vertex) { return holds(outer, vertices_m, points_m[vertex]); });
  };
  return holdsAny(body_, at_m, tool_, corners_m_) ||
         (closed_tool_ && holdsAny(tool_, corners_m_, body_, at_m));
}

}  // namespace fissure
