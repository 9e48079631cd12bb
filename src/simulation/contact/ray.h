#pragma once

#include <optional>

#include "base/geometry.h"

namespace fissure {

/// A ray, prepared for tests against many triangles (Woop, Benthin and Wald, Watertight Ray/Triangle
/// Intersection, JCGT 2013).
class Ray {
 public:
  /// `direction` must have unit length; hits lie at distances 0..max_distance_m from the origin.
  Ray(const Vec3& origin_m, const Vec3& direction, double max_distance_m);

  const Vec3& origin() const { return origin_; }
  const Vec3& direction() const { return direction_; }
  const Vec3& inverseDirection() const { return inverse_direction_; }  ///< components may be infinite
  double maxDistance() const { return max_distance_; }

  struct TriangleHit {
    double distance_m = 0;
    std::array<double, 3> weights{};  ///< barycentric coordinates of the hit, sum 1
    /// Outward triangle normal . direction: > 0 where the ray leaves the body, < 0 where it enters.
    double cosine = 0;
  };

  /// The hit of triangle abc; no value where the ray misses. Watertight: a ray through a shared edge or
  /// vertex hits at least one of the triangles there, because the edge functions of two triangles have
  /// exactly opposite signs. Grazing rays (|cosine| < 1e-9) and degenerate triangles give no hit.
  std::optional<TriangleHit> intersect(const Vec3& a, const Vec3& b, const Vec3& c) const;

 private:
  Vec3 origin_;
  Vec3 direction_;
  Vec3 inverse_direction_;
  double max_distance_;
  int kx_, ky_, kz_;
  double shear_x_, shear_y_, scale_z_;
};

}  // namespace fissure
