#pragma once

#include "base/geometry.h"
#include "base/tetrahedra.h"
#include "scenario/shapes.h"

namespace fissure {

/// The surface of a LobesShape, a half ellipsoid on its flat side, parted into two lobes by a slit; metres.
/// The origin is the middle of the flat side, y is up, the slit runs along z. The surface is closed with
/// outward faces, and exactly mirror-symmetric in x = 0 and z = 0. Deterministic.
TriangleMesh makeLobes(const LobesShape& shape);

/// The volume whose surface is makeLobes': six tetrahedra per cell of the block that is mapped to the
/// ellipsoid, with the same symmetries. Cells inside, along the upper edges of the block, are kept from
/// becoming as flat as those edges on the ellipsoid.
TetrahedralMesh makeLobesTetrahedra(const LobesShape& shape);

}  // namespace fissure
