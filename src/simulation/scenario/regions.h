#pragma once

#include <algorithm>

#include "base/geometry.h"

namespace fissure {

/// An upright box, its bounds included.
struct BoxRegion {
  Vec3 min_m = Vec3::Zero();
  Vec3 max_m = Vec3::Zero();

  bool holds(const Vec3& point_m) const {
    return (point_m.array() >= min_m.array()).all() && (point_m.array() <= max_m.array()).all();
  }

  bool operator==(const BoxRegion&) const = default;
};

/// All that is at most a radius from the straight line between two points, which may be one: a vessel.
struct CapsuleRegion {
  Vec3 from_m = Vec3::Zero();
  Vec3 to_m = Vec3::Zero();
  double radius_m = 0;  ///< > 0

  bool holds(const Vec3& point_m) const {
    const Vec3 along_m = to_m - from_m, there_m = point_m - from_m;
    const double length_squared_m2 = along_m.squaredNorm();
    const double share = length_squared_m2 > 0 ? there_m.dot(along_m) / length_squared_m2 : 0;
    return (there_m - std::clamp(share, 0.0, 1.0) * along_m).norm() <= radius_m;
  }

  bool operator==(const CapsuleRegion&) const = default;
};

}  // namespace fissure
