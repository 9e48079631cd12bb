#pragma once

#include <string>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// What can be wrong with a volume of tetrahedra, in the order in which it is told.
enum class VolumeDefectKind {
  no_tetrahedra,
  index_out_of_range,
  non_finite_vertices,
  unused_vertices,
  inverted_tetrahedra,  ///< of negative volume
  flat_tetrahedra,      ///< volume below a 1e-12th of a cube on the longest edge, or a corner named twice
  sliver_tetrahedra,    ///< radiusRatio() below 0.01, where neither inverted nor flat
  overlapping_faces,    ///< sides of three tetrahedra or more, or of two that lie on the same side of it
  other_vertices,       ///< of the surface: the volume has others in their places
  other_boundary,       ///< triangles of the boundary that the surface has not, or the other way round
  pieces,               ///< that share no side, where there are several
};

struct VolumeDefect {
  VolumeDefectKind kind;
  std::size_t count = 0;
  std::string text;  ///< one line with the count, e.g. "3 inverted tetrahedra (of negative volume)"
};

/// All that is wrong with a volume as that of a surface. Any mesh may be given. Tetrahedra that name a vertex
/// that does not exist are counted and then left out; those that name one twice are flat and have no sides.
std::vector<VolumeDefect> inspectTetrahedra(const TetrahedralMesh& mesh, const TriangleMesh& surface);

/// True for what an elastic body cannot be simulated with: all but slivers.
bool spoilsVolume(VolumeDefectKind kind);

struct TetrahedraQuality {
  double worst = 0;  ///< least radiusRatio(): 1 for a regular tetrahedron, 0 for a flat one
  double mean = 0;
  double volume_m3 = 0;
};

/// The shapes and the volume of a mesh whose vertices all exist and are finite; zeros where there is none.
TetrahedraQuality qualityOf(const TetrahedralMesh& mesh);

}  // namespace fissure
