#pragma once

#include <array>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// Integer coordinates of a point in an octahedron whose corners lie at +-`layers` on the axes. The layer of
/// a point is the sum of the coordinates' magnitudes.
using OctahedronPoint = std::array<int, 3>;

/// A ball of tetrahedra.
struct BallTetrahedra {
  TetrahedralMesh mesh;
  std::size_t on_surface = 0;           ///< number of vertices on the surface, which come first
  int layers = 1;                       ///< 2^subdivisions
  std::vector<OctahedronPoint> points;  ///< [vertex] its point of the octahedron
  std::vector<int> vertices;            ///< [point] its vertex, -1 outside; read by vertex()

  /// Index of the vertex at a point of the octahedron.
  int vertex(const OctahedronPoint& point) const;
};

/// The ball whose surface is makeSphere(radius_m, subdivisions): 8 x 8^subdivisions tetrahedra. The planes of
/// integer x, y, z and |x| + |y| + |z| cut the octahedron into tetrahedra and small octahedra; each of these
/// is cut into four tetrahedra along the diagonal with the best radius ratio of the worst one. A point lies
/// at its layer's share of the radius, in the direction of the midpoint of its neighbours in the lattice of
/// twice the spacing; on the surface these are makeSphere's projected midpoints. Mirror-symmetric in x = 0, y
/// = 0 and z = 0 where the surface is. Deterministic.
BallTetrahedra makeBallTetrahedra(double radius_m, int subdivisions);

}  // namespace fissure
