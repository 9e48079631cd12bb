#pragma once

#include <array>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// Appends the six tetrahedra of a hexahedron around its diagonal from corner `start` to the opposite corner
/// (Kuhn 1960). `corners` are vertex indices; bit 0 of a corner's number is its side in x, bit 1 in y, bit 2
/// in z. Each face of the hexahedron is cut along its diagonal through that end of the hexahedron's diagonal
/// which lies in the face.
void addKuhnTetrahedra(const std::array<int, 8>& corners, unsigned start,
                       std::vector<Tetrahedron>& tetrahedra);

}  // namespace fissure
