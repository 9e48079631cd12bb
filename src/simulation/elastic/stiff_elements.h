#pragma once

#include <vector>

#include "base/tetrahedra.h"
#include "elastic/material.h"

namespace fissure {

/// The tetrahedra that may make a mesh's substeps short, slivers or cells far smaller than the others: the
/// stiffest of each hundred (rounded up), the stiffest first. Stiffness is the largest eigenvalue of a
/// tetrahedron's own P-wave (and viscous) stiffness over the lumped masses of its corners, which is at most
/// that of the whole mesh. `materials.of_elements` may be empty. Every tetrahedron must have a volume.
std::vector<int> stiffestElements(const TetrahedralMesh& mesh, const ElementMaterials& materials);

/// The same materials, but that `elements` are a thousand times softer and less viscous: as if they were not
/// there.
ElementMaterials softened(ElementMaterials materials, const TetrahedralMesh& mesh,
                          const std::vector<int>& elements);

}  // namespace fissure
