#pragma once

#include <optional>
#include <vector>

#include "base/tetrahedra.h"
#include "scenario/shapes.h"

namespace fissure {

/// The tetrahedra of a shape, in its own frame, metres: the first vertices are those of makeSurface(shape),
/// bit for bit and in the same order, and the boundary has the same triangles. Every tetrahedron has a
/// positive volume. No value for shapes whose tetrahedra come from a file or a mesher. Deterministic.
std::optional<TetrahedralMesh> makeTetrahedra(const SurfaceShape& shape);

/// A box with full edge lengths `size_m` whose surface is makeBox's, with six tetrahedra per cell, which are
/// mirrored between neighbouring cells.
TetrahedralMesh makeBoxTetrahedra(const Vec3& size_m, const std::array<int, 3>& cells);

/// The sides that belong to only one tetrahedron, outward for tetrahedra of positive volume, in the order of
/// their least vertices. All indices must be valid.
std::vector<Face> boundaryFaces(const TetrahedralMesh& mesh);

}  // namespace fissure
