#include "contact/ray.h"

#include <cmath>
#include <utility>

namespace fissure {

namespace {
constexpr double kGrazingCosine = 1e-9;
}

Ray::Ray(const Vec3& origin_m, const Vec3& direction, double max_distance_m)
    : origin_(origin_m),
      direction_(direction),
      inverse_direction_(direction.cwiseInverse()),
      max_distance_(max_distance_m) {
  direction.cwiseAbs().maxCoeff(&kz_);
  kx_ = (kz_ + 1) % 3;
  ky_ = (kx_ + 1) % 3;
  if (direction[kz_] < 0) std::swap(kx_, ky_);  // keeps the triangles' winding
  shear_x_ = direction[kx_] / direction[kz_];
  shear_y_ = direction[ky_] / direction[kz_];
  scale_z_ = 1.0 / direction[kz_];
}

std::optional<Ray::TriangleHit> Ray::intersect(const Vec3& a, const Vec3& b, const Vec3& c) const {
  const Vec3 ra = a - origin_;
  const Vec3 rb = b - origin_;
  const Vec3 rc = c - origin_;
  const double ax = ra[kx_] - shear_x_ * ra[kz_], ay = ra[ky_] - shear_y_ * ra[kz_];
  const double bx = rb[kx_] - shear_x_ * rb[kz_], by = rb[ky_] - shear_y_ * rb[kz_];
  const double cx = rc[kx_] - shear_x_ * rc[kz_], cy = rc[ky_] - shear_y_ * rc[kz_];
  const double u = cx * by - cy * bx;
  const double v = ax * cy - ay * cx;
  const double w = bx * ay - by * ax;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double det = u + v + w;
  if (det == 0) return std::nullopt;
  const double t = scale_z_ * (u * ra[kz_] + v * rb[kz_] + w * rc[kz_]) / det;
  if (!(t >= 0 && t <= max_distance_)) return std::nullopt;

  const Vec3 normal = (rb - ra).cross(rc - ra);
  const double length = normal.norm();
  const double cosine = normal.dot(direction_) / length;
  if (!(std::abs(cosine) >= kGrazingCosine)) return std::nullopt;
  return TriangleHit{.distance_m = t, .weights = {u / det, v / det, w / det}, .cosine = cosine};
}

}  // namespace fissure
