#pragma once

#include "base/tetrahedra.h"

namespace fissure {

/// The volume whose surface is makeCapsule's for the same arguments: the halves of makeBallTetrahedra's ball
/// and, between them, `rows` layers of prisms on the triangles of the ball's section x = 0, with three
/// tetrahedra each. `rows` > 0. The mesh is mirror-symmetric in y = 0 and z = 0, and for even `rows` in x =
/// 0.
TetrahedralMesh makeCapsuleTetrahedra(double radius_m, double length_m, int subdivisions, int rows);

}  // namespace fissure
