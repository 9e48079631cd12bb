#pragma once

#include <string>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// Defects of a volume of tetrahedra, in the order in which they are reported.
enum class VolumeDefectKind {
  no_tetrahedra,
  index_out_of_range,
  non_finite_vertices,
  unused_vertices,
  inverted_tetrahedra,  ///< of negative volume
  flat_tetrahedra,      ///< volume below a 1e-12th of a cube on the longest edge, or a corner named twice
  sliver_tetrahedra,    ///< radiusRatio() below 0.01, where neither inverted nor flat
  overlapping_faces,    ///< sides of three or more tetrahedra, or of two that lie on the same side of it
  other_vertices,       ///< its first vertices are not those of the surface
  other_boundary,       ///< triangles of the boundary that are not in the surface, or the reverse
  pieces,               ///< several pieces that share no side
};

struct VolumeDefect {
  VolumeDefectKind kind;
  std::size_t count = 0;
  /// One line with the count, e.g. "3 inverted tetrahedra (of negative volume)".
  std::string text;
};

/// All defects of `mesh` as the volume of `surface`. Any mesh may be given. Tetrahedra that name a vertex
/// that does not exist are counted and then ignored; those that name one twice are flat and have no sides.
std::vector<VolumeDefect> inspectTetrahedra(const TetrahedralMesh& mesh, const TriangleMesh& surface);

/// True for defects with which an elastic body cannot be simulated: all but slivers.
bool spoilsVolume(VolumeDefectKind kind);

struct TetrahedraQuality {
  double worst = 0;  ///< least radiusRatio(), 1 for a regular tetrahedron and 0 for a flat one
  double mean = 0;
  double volume_m3 = 0;
};

/// Quality and volume of a mesh whose indices are valid and whose vertices are finite; zeros without
/// tetrahedra.
TetrahedraQuality qualityOf(const TetrahedralMesh& mesh);

}  // namespace fissure
