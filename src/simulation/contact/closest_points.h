#pragma once

#include <array>

#include "base/geometry.h"

namespace fissure {

/// Barycentric coordinates of the point of triangle abc that is nearest to `p`. They are exactly 0 for the
/// corners that do not take part where that point is on an edge or a corner.
std::array<double, 3> nearestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Parameters, 0..1 along ab and cd, of the points at which the two segments are nearest to each other; for
/// parallel segments one such pair.
std::array<double, 2> nearestOnSegments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace fissure
