#pragma once

#include <array>

#include "base/geometry.h"

namespace fissure {

/// Barycentric coordinates of the point of triangle abc that is nearest to `p`; 0 exactly where that point is
/// on an edge or a corner.
std::array<double, 3> nearestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Shares, 0..1, along segments ab and cd of the points where these are nearest to each other. Parallel
/// segments: one such pair.
std::array<double, 2> nearestOnSegments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace fissure
