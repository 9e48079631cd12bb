#include "contact/closest_points.h"

#include <algorithm>

namespace fissure {

// Which of the seven regions of the plane holds the point (Ericson, Real-Time Collision Detection, 5.1.5).
std::array<double, 3> nearestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = 1 / (va + vb + vc);
  return {1 - vb * sum - vc * sum, vb * sum, vc * sum};
}

std::array<double, 2> nearestOnSegments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr double kParallel = 1e-14;  // squared sine of the angle between both
  const Vec3 ab = b - a, cd = d - c, ca = a - c;
  const double ab2 = ab.squaredNorm(), cd2 = cd.squaredNorm();
  if (!(ab2 > 0) || !(cd2 > 0)) return {0, 0};
  const double along_ab = ab.dot(ca), along_cd = cd.dot(ca), both = ab.dot(cd);
  const double squared_area = ab2 * cd2 - both * both;
  double s = squared_area > kParallel * ab2 * cd2
                 ? std::clamp((both * along_cd - along_ab * cd2) / squared_area, 0.0, 1.0)
                 : 0.5;
  double t = (both * s + along_cd) / cd2;
  if (t < 0) {
    t = 0;
    s = std::clamp(-along_ab / ab2, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((both - along_ab) / ab2, 0.0, 1.0);
  }
  return {s, t};
}

}  // namespace fissure
