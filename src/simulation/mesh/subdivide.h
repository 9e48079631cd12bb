#pragma once

#include <cstddef>

#include "base/geometry.h"

namespace fissure {

/// Halves edges longer than `max_edge` at vertices that both their triangles share, as often as needed: the
/// surface stays where it is, and closed where it was. Stops when there are more than `most`; false
/// then. Vertices and edges must be finite, `max_edge` > 0.
bool subdivide(TriangleMesh& mesh, double max_edge, std::size_t most);

}  // namespace fissure
