#pragma once

#include <array>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// Whole coordinates in an octahedron whose corners lie at `layers` on the axes; a point's layer is the sum
/// of their magnitudes.
using OctahedronPoint = std::array<int, 3>;

/// A ball of tetrahedra.
struct BallTetrahedra {
  TetrahedralMesh mesh;
  std::size_t on_surface = 0;           ///< of the vertices, the first ones
  int layers = 1;                       ///< 2^subdivisions
  std::vector<OctahedronPoint> points;  ///< of each vertex
  std::vector<int> vertices;            ///< of each point, -1 outside; vertex() reads it

  /// The vertex of a point of the octahedron.
  int vertex(const OctahedronPoint& point) const;
};

/// The ball whose surface is makeSphere(radius_m, subdivisions): 8 x 8^subdivisions tetrahedra. The planes
/// through whole x, y, z and |x| + |y| + |z| cut the octahedron into tetrahedra and small octahedra; of each
/// of these the diagonal is taken whose four tetrahedra are best, by the radius ratio of the worst one. A
/// point lies at its layer's share of the radius, in the direction of the middle of its neighbours in the
/// lattice of twice the spacing: on the surface makeSphere's own projected midpoints. Mirror-symmetric in
/// x = 0, y = 0 and z = 0 where the surface is. Deterministic.
BallTetrahedra makeBallTetrahedra(double radius_m, int subdivisions);

}  // namespace fissure
