#pragma once

#include <array>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Corner indices of a tetrahedron: seen from the fourth corner, the first three run counter-clockwise, so
/// that its volume dot(b - a, cross(c - a, d - a)) / 6 is positive.
using Tetrahedron = std::array<int, 4>;

/// A volume of linear tetrahedra, metres. Its first vertices are those of its surface, in the surface's own
/// order and bit for bit the same; the vertices inside follow.
struct TetrahedralMesh {
  std::vector<Vec3> vertices_m;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<int> tags = {};  ///< one per tetrahedron, as a mesh file numbers its parts; empty: it has none
};

}  // namespace fissure
