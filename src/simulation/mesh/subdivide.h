#pragma once

#include <cstddef>

#include "base/geometry.h"

namespace fissure {

/// Halves edges until none is longer than `max_edge` (in the vertices' unit), at new vertices that both
/// triangles of an edge share: the shape does not change, and a closed surface stays closed. Stops and
/// returns false when there are more than `most` triangles. Vertices must be finite, `max_edge` > 0.
bool subdivide(TriangleMesh& mesh, double max_edge, std::size_t most);

}  // namespace fissure
