#pragma once

#include <array>

#include "base/geometry.h"
#include "base/tetrahedra.h"

namespace fissure {

/// Positions of the corners of one tetrahedron; its indices must be valid.
inline std::array<Vec3, 4> cornersOf(const TetrahedralMesh& mesh, const Tetrahedron& tetrahedron) {
  const auto corner = [&](std::size_t k) {
    return mesh.vertices_m[static_cast<std::size_t>(tetrahedron[k])];
  };
  return {corner(0), corner(1), corner(2), corner(3)};
}

/// Volume in the cube of the corners' unit, negative for an inverted tetrahedron.
double signedVolume(const std::array<Vec3, 4>& corners);

/// Three times the radius of the inscribed sphere over that of the circumscribed one, with the sign of the
/// volume: 1 for a regular tetrahedron, 0 for a flat one, -1 at least. NaN where a corner is not finite.
double radiusRatio(const std::array<Vec3, 4>& corners);

/// Six times the volume over the cube of the longest edge, with its sign: 0 for a flat tetrahedron. NaN
/// where a corner is not finite.
double relativeVolume(const std::array<Vec3, 4>& corners);

}  // namespace fissure
