#pragma once

#include <algorithm>

#include "base/geometry.h"
#include "scenario/key.h"

namespace fissure {

/// A box with axis-parallel edges, its boundary included.
struct BoxRegion {
  Vec3 min_m = Vec3::Zero();
  Vec3 max_m = Vec3::Zero();

  bool holds(const Vec3& point_m) const {
    return (point_m.array() >= min_m.array()).all() && (point_m.array() <= max_m.array()).all();
  }

  bool operator==(const BoxRegion&) const = default;
};

/// A capsule: all points within a radius of the segment between two points, which may coincide.
struct CapsuleRegion {
  Vec3 from_m = Vec3::Zero();
  Vec3 to_m = Vec3::Zero();
  double radius_m = 0;

  bool holds(const Vec3& point_m) const {
    const Vec3 along_m = to_m - from_m, there_m = point_m - from_m;
    const double length_squared_m2 = along_m.squaredNorm();
    const double share = length_squared_m2 > 0 ? there_m.dot(along_m) / length_squared_m2 : 0;
    return (there_m - std::clamp(share, 0.0, 1.0) * along_m).norm() <= radius_m;
  }

  bool operator==(const CapsuleRegion&) const = default;
};

template <class Io>
void describe(Io& io, BoxRegion& r) {
  io.field("min_m", r.min_m,
           Key("Corner of the box with the smallest coordinates; it belongs to the box.").required());
  io.field("max_m", r.max_m,
           Key("Corner of the box with the largest coordinates, at least `min_m` in each direction; it "
               "belongs to the box.")
               .required());
}

template <class Io>
void describe(Io& io, CapsuleRegion& r) {
  io.field("from_m", r.from_m, Key("First end of the capsule's axis.").required());
  io.field("to_m", r.to_m,
           Key("Second end of the capsule's axis; equal to `from_m` it makes a ball.").required());
  io.field("radius_m", r.radius_m,
           Key("Largest distance from the axis that belongs to the capsule.").above(0).required());
}

}  // namespace fissure
