#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure::test {

/// Distance between two triangle surfaces that do not cross, the obvious way: over all pairs of triangles the
/// least distance of a corner from a triangle or of an edge from an edge.
double slowDistance_m(const TriangleMesh& one, const TriangleMesh& other);

}  // namespace fissure::test
