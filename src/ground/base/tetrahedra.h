#pragma once

#include <array>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Corner indices of a tetrahedron: seen from the fourth corner, the first three run counter-clockwise, so
/// that its volume dot(b - a, cross(c - a, d - a)) / 6 is positive.
using Tetrahedron = std::array<int, 4>;

/// A mesh of linear tetrahedra, metres. Its first vertices are those of its surface, bit for bit and in the
/// same order; the vertices inside follow.
struct TetrahedralMesh {
  std::vector<Vec3> vertices_m;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<int> tags = {};  ///< [tetrahedron] number of its part in the mesh file; empty: no parts
};

}  // namespace fissure
