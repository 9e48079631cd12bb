#pragma once

#include "base/tetrahedra.h"

namespace fissure {

/// The volume whose surface is makeCapsule's of the same sizes: the halves of makeBallTetrahedra's ball and
/// between them `rows` of prisms on the triangles of its section x = 0, three tetrahedra each. `rows` > 0;
/// where it is even the mesh is its own mirror image in x = 0, as it always is in y = 0 and z = 0.
TetrahedralMesh makeCapsuleTetrahedra(double radius_m, double length_m, int subdivisions, int rows);

}  // namespace fissure
