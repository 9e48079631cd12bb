#pragma once

#include <vector>

#include "base/tetrahedra.h"
#include "elastic/material.h"

namespace fissure {

/// Indices of the stiffest hundredth (rounded up) of a mesh's tetrahedra, the stiffest first: slivers, or
/// cells far smaller than the others, which may be the reason for short substeps. The stiffness of a
/// tetrahedron is the largest eigenvalue of its own P-wave (and viscous) stiffness over the lumped masses of
/// its corners, which is at most that of the whole mesh. `materials.of_elements` may be empty. All volumes
/// must be positive.
std::vector<int> stiffestElements(const TetrahedralMesh& mesh, const ElementMaterials& materials);

/// The same materials, except that `elements` are a thousand times softer and less viscous, as if they were
/// absent.
ElementMaterials softened(ElementMaterials materials, const TetrahedralMesh& mesh,
                          const std::vector<int>& elements);

}  // namespace fissure
