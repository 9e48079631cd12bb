#pragma once

#include <array>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// Appends the six tetrahedra around the diagonal of a hexahedron from corner `start` to the opposite one
/// (Kuhn 1960): each follows three edges from `start`. Bit 0 of a corner's number is its side in x, bit 1 in
/// y, bit 2 in z. Each face of the hexahedron is cut along the diagonal through whichever of the two ends
/// lies in it.
void addKuhnTetrahedra(const std::array<int, 8>& corners, unsigned start,
                       std::vector<Tetrahedron>& tetrahedra);

}  // namespace fissure
