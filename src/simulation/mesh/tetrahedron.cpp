#include "mesh/tetrahedron.h"

#include <algorithm>
#include <cmath>

namespace fissure {

double signedVolume(const std::array<Vec3, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  return (b - a).dot((c - a).cross(d - a)) / 6;
}

double radiusRatio(const std::array<Vec3, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Vec3 vw = v.cross(w), wu = w.cross(u), uv = u.cross(v);
  // With V the volume and S the surface: inscribed 3 V / S, circumscribed |to_centre| / (12 V).
  const double volume = u.dot(vw) / 6;
  const double surface = 0.5 * (vw.norm() + wu.norm() + uv.norm() + (vw + wu + uv).norm());
  const Vec3 to_centre = u.squaredNorm() * vw + v.squaredNorm() * wu + w.squaredNorm() * uv;
  const double below = surface * to_centre.norm();
  return below == 0 ? 0 : 108 * volume * std::abs(volume) / below;
}

double relativeVolume(const std::array<Vec3, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  double longest = 0;
  for (const Vec3& edge : {Vec3(b - a), Vec3(c - a), Vec3(d - a), Vec3(c - b), Vec3(d - b), Vec3(d - c)})
    longest = std::max(longest, edge.norm());
  return longest == 0 ? 0 : 6 * signedVolume(corners) / (longest * longest * longest);
}

}  // namespace fissure
