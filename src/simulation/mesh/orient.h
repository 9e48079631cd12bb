#pragma once

#include <cstddef>

#include "base/geometry.h"

namespace fissure {

/// Turns triangles so that those which share an edge with exactly one other agree with it about the outside:
/// in each piece the fewer. Returns how many were turned.
std::size_t orientConsistently(TriangleMesh& mesh);

/// Turns closed and consistent pieces whose volume has the wrong sign: outward, inward where an odd number of
/// other such pieces enclose them. Returns how many were turned.
std::size_t turnOutward(TriangleMesh& mesh);

/// Becomes its mirror image in x = 0, faces outward again.
void mirror(TriangleMesh& mesh);

}  // namespace fissure
