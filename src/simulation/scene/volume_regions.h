#pragma once

#include <vector>

#include "base/tetrahedra.h"
#include "scenario/bodies.h"

namespace fissure {

/// Of each tetrahedron of the body's volume, in the frame of its shape, the region that has it: 0 where none
/// has, else 1 + its index in the settings; of several the last. Empty where the body has no regions. Throws
/// InputError, with one line, for a tag where the mesh has none and for a region that is left without a
/// tetrahedron.
std::vector<int> volumeRegions(const BodySettings& body, const TetrahedralMesh& mesh);

}  // namespace fissure
