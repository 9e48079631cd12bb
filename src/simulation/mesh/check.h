#pragma once

#include <string>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// What can be wrong with a surface, in the order in which it is told.
enum class DefectKind {
  no_triangles,
  index_out_of_range,
  non_finite_vertices,
  unreferenced_vertices,
  duplicate_vertices,
  degenerate_triangles,  ///< without area, and so without a normal
  sliver_triangles,      ///< area below a millionth of the longest edge squared; the degenerate ones too
  duplicate_faces,       ///< the same three corners again, in any order
  boundary_edges,        ///< of one triangle
  non_manifold_edges,    ///< of more than two triangles
  inconsistent_edges,    ///< run through more than once in one direction
  no_volume,
  inside_out,
  shells,               ///< pieces that share no vertex, where there are several
  size,                 ///< beyond reason
  unused_vertices,      ///< of a file: in no face of it, whether its reader kept them or not
  non_planar_polygons,  ///< of a file: what triangles they become is the reader's choice
};

struct Defect {
  DefectKind kind;
  std::size_t count = 0;
  std::string text;  ///< one line with the count, e.g. "3 boundary edges (the surface is open)"
};

/// All that is wrong with a surface but its size. Any mesh may be given, also one with indices out of range
/// or without triangles. Faces that name a vertex twice, or one that does not exist, are counted and then
/// left out of what is said about edges; the sense (outward or inside out) is judged only where the surface
/// is closed and consistent, shell by shell: one that is turned inward is right as a cavity inside another.
/// `unit_m`: metres in the vertices' unit.
std::vector<Defect> inspectSurface(const TriangleMesh& mesh, double unit_m = 1);

/// True for what a soft body cannot be simulated with: all but slivers, several shells and what is odd about
/// a file alone.
bool spoilsBody(DefectKind kind);

/// True when a tool cannot be used at all: no triangles, bad vertices or indices, a size beyond reason,
/// neighbours that disagree about the outside. One that is open can: it only has no inside.
bool spoilsTool(DefectKind kind);

/// True when points can be told to lie inside the surface: it is closed, with outward faces.
bool hasInside(const TriangleMesh& mesh);

/// Enclosed volume of a closed, outward surface by the divergence theorem, m^3; negative when inside out.
double signedVolume_m3(const TriangleMesh& mesh);

}  // namespace fissure
