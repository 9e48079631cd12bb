#pragma once

#include "base/geometry.h"

namespace fissure {

/// Makes one of vertices that are no farther apart than `tolerance` (0: equal ones, where -0 is 0), at the
/// place of the first of them; chains of near vertices become one as well. The others stay in their order.
/// Vertices that are not finite are left alone. Triangles keep their number and order, also those that lose
/// their area.
void weldVertices(TriangleMesh& mesh, double tolerance);

}  // namespace fissure
