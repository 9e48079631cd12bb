#pragma once

#include "base/geometry.h"

namespace fissure {

/// Whether a point of the box's frame lies inside the box of these half edge lengths.
bool boxHolds(const Vec3& half_m, const Vec3& point_m);

/// The face of the box through which the segment from an outside point enters, 2 x axis + (0: positive, 1:
/// negative); -1: it misses.
int boxEntryFace(const Vec3& half_m, const Vec3& from_m, const Vec3& to_m);

}  // namespace fissure
