#pragma once

#include <cstddef>

#include "base/geometry.h"

namespace fissure {

/// Turns triangles so that neighbours across edges of exactly two triangles have the same orientation; in
/// each connected piece the smaller number is turned. Returns how many were turned.
std::size_t orientConsistently(TriangleMesh& mesh);

/// Turns closed and consistent pieces whose volume has the wrong sign, so that their faces point outward, or
/// inward where an odd number of other such pieces enclose them (a cavity). Returns how many pieces were
/// turned.
std::size_t turnOutward(TriangleMesh& mesh);

/// Mirrors the mesh in x = 0 and turns its faces, so that outward faces stay outward.
void mirror(TriangleMesh& mesh);

}  // namespace fissure
