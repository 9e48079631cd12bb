#pragma once

#include <vector>

#include "base/tetrahedra.h"
#include "scenario/bodies.h"

namespace fissure {

/// [tetrahedron] the region of each tetrahedron of the body's volume `mesh`, which is in the frame of the
/// body's shape: 0 for none, else 1 + the index in the settings; where several regions hold a tetrahedron,
/// the last one. Empty where the body has no regions. Throws InputError, with one line, for a tag where the
/// mesh has no tags and for a region without a tetrahedron.
std::vector<int> volumeRegions(const BodySettings& body, const TetrahedralMesh& mesh);

}  // namespace fissure
