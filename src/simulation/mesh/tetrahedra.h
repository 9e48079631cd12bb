#pragma once

#include <optional>
#include <vector>

#include "base/tetrahedra.h"
#include "scenario/shapes.h"

namespace fissure {

/// The volume of a shape, in its own frame: its first vertices are those of makeSurface(shape), in their
/// order and bit for bit, and its boundary has the same triangles. Every tetrahedron has a positive volume.
/// Nothing for shapes whose tetrahedra a file or a mesher has (tetrahedraOf has none). Deterministic.
std::optional<TetrahedralMesh> makeTetrahedra(const SurfaceShape& shape);

/// Box of full edge lengths `size_m` whose surface is makeBox's: six tetrahedra a cell, which mirror those of
/// the cells beside it.
TetrahedralMesh makeBoxTetrahedra(const Vec3& size_m, const std::array<int, 3>& cells);

/// The triangles that one tetrahedron alone has as a side, outward where its volume is positive, in the order
/// of their least vertices. All vertices must exist.
std::vector<Face> boundaryFaces(const TetrahedralMesh& mesh);

}  // namespace fissure
