#pragma once

#include "base/geometry.h"
#include "base/tetrahedra.h"
#include "scenario/shapes.h"

namespace fissure {

/// Two lobes of a half ellipsoid that lies on its flat side, parted by a slit (LobesShape says how). The
/// origin is the middle of the flat side, y up, the slit along z. Closed, outward faces; each vertex, edge
/// and face has its exact mirror image at x = 0 and at z = 0. Deterministic for given sizes.
TriangleMesh makeLobes(const LobesShape& shape);

/// The volume whose surface is makeLobes': six tetrahedra for each cell of the block, as symmetric. Inside,
/// cells along the upper edges of the block are kept from becoming as flat as these are on the ellipsoid.
TetrahedralMesh makeLobesTetrahedra(const LobesShape& shape);

}  // namespace fissure
