#pragma once

#include "base/geometry.h"

namespace fissure {

/// The ground: a half-space at rest that tissue stays out of. Tissue is above it when all of its vertices
/// are.
struct HalfSpace {
  Vec3 point_m = Vec3::Zero();  ///< a point on its surface, scene frame
  Vec3 normal = Vec3::UnitY();  ///< unit, out of the half-space, scene frame
  double friction = 0;          ///< Coulomb's coefficient of a contact is the product of this and the body's

  /// Height of a point (scene frame) above the surface; negative below it.
  double height_m(const Vec3& at_m) const { return (at_m - point_m).dot(normal); }
  /// Whether a point is below the surface by more than rounding (1 nm).
  bool holdsInside(const Vec3& at_m) const { return height_m(at_m) < -1e-9; }
};

}  // namespace fissure
