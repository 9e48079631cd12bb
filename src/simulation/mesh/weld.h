#pragma once

#include "base/geometry.h"

namespace fissure {

/// Merges vertices that are no farther apart than `tolerance`, in the vertices' unit (0: equal ones, where -0
/// equals 0), at the position of the first of them; chains of near vertices are merged too. The order of the
/// remaining vertices does not change. Vertices that are not finite are left alone. Triangles keep their
/// number and order, even those that lose their area.
void weldVertices(TriangleMesh& mesh, double tolerance);

}  // namespace fissure
