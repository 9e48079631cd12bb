#pragma once

#include <optional>

#include "base/geometry.h"

namespace fissure {

/// A ray prepared for many triangles (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT
/// 2013).
class Ray {
 public:
  /// `direction` must have unit length; hits lie at distances 0..max_distance_m from the origin.
  Ray(const Vec3& origin_m, const Vec3& direction, double max_distance_m);

  const Vec3& origin() const { return origin_; }
  const Vec3& direction() const { return direction_; }
  const Vec3& inverseDirection() const { return inverse_direction_; }  ///< a component may be infinite
  double maxDistance() const { return max_distance_; }

  struct TriangleHit {
    double distance_m = 0;
    std::array<double, 3> weights{};  ///< barycentric coordinates of the hit, sum 1
    double cosine = 0;  ///< outward triangle normal . direction: > 0 the ray leaves the body, < 0 it enters
  };

  /// Watertight: of the triangles round a shared edge or vertex at least one is hit by a ray through it,
  /// because the sign of each edge function is exactly opposite in the two triangles. A grazing ray (|cosine|
  /// < 1e-9) and a degenerate triangle are no hit.
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
