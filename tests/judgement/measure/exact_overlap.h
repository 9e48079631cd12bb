#pragma once

#include "base/geometry.h"

namespace fissure::test {

/// Whether two triangle surfaces share a point, or a connected part of one encloses a corner of the other:
/// decided on signs of determinants in exact arithmetic, all pairs of triangles. `one` is closed; `other`
/// encloses nothing unless it is closed, too. Corners in one frame, metres.
bool exactOverlap(const TriangleMesh& one, const TriangleMesh& other, bool other_closed);

}  // namespace fissure::test
