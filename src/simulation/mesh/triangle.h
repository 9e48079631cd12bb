#pragma once

#include <array>

#include "base/geometry.h"

namespace fissure {

/// Positions of the corners of one triangle; its indices must be valid.
inline std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, const Face& face) {
  const auto corner = [&](std::size_t k) { return mesh.vertices_m[static_cast<std::size_t>(face[k])]; };
  return {corner(0), corner(1), corner(2)};
}

/// Twice the area of a triangle over its longest edge squared: 0 when it has no area. NaN where a corner is
/// not finite.
double relativeHeight(const std::array<Vec3, 3>& corners);

/// Triangles with at most this relativeHeight() are degenerate: they have no usable normal.
constexpr double degenerate_height = 1e-12;

}  // namespace fissure
