#pragma once

#include "base/geometry.h"

namespace fissure {

/// The ground: a half-space at rest that tissue stays out of. Tissue is above it where none of its vertices
/// is below, whatever its triangles do.
struct HalfSpace {
  Vec3 point_m = Vec3::Zero();  ///< a point of its surface, scene frame
  Vec3 normal = Vec3::UnitY();  ///< unit, out of it
  double friction = 0;          ///< Coulomb's coefficient is the product of this and the body's

  /// How far a point stands above its surface; below it the height is negative.
  double height_m(const Vec3& at_m) const { return (at_m - point_m).dot(normal); }
  /// Is a point below, by more than rounding?
  bool holdsInside(const Vec3& at_m) const { return height_m(at_m) < -1e-9; }
};

}  // namespace fissure
