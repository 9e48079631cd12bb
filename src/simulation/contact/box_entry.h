#pragma once

#include "base/geometry.h"

namespace fissure {

/// Whether a point, in the box's frame, lies inside the box with half edge lengths `half_m`.
bool boxHolds(const Vec3& half_m, const Vec3& point_m);

/// The face of the box through which a segment from an outside point enters it, as 2 x axis + (0: positive
/// side, 1: negative side); -1 where the segment misses the box.
int boxEntryFace(const Vec3& half_m, const Vec3& from_m, const Vec3& to_m);

}  // namespace fissure
