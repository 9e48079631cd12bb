#pragma once

#include <string>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Defects of a surface, in the order in which they are reported.
enum class DefectKind {
  no_triangles,
  index_out_of_range,
  non_finite_vertices,
  unreferenced_vertices,
  duplicate_vertices,
  degenerate_triangles,  ///< zero area, and so no normal
  sliver_triangles,      ///< area below a millionth of the longest edge squared; the degenerate ones too
  duplicate_faces,       ///< the same three corners again, in any order
  boundary_edges,        ///< edges of only one triangle
  non_manifold_edges,    ///< edges of more than two triangles
  inconsistent_edges,    ///< edges that two triangles run through in the same direction
  no_volume,
  inside_out,
  shells,               ///< several pieces that share no vertex
  size,                 ///< implausible size
  unused_vertices,      ///< in a file: vertices in no face, whether its reader kept them or not
  non_planar_polygons,  ///< in a file: the triangles they are split into depend on the reader
};

struct Defect {
  DefectKind kind;
  std::size_t count = 0;
  /// One line with the count, e.g. "3 boundary edges (the surface is open)".
  std::string text;
};

/// All defects of a surface but those of its size. Any mesh may be given, even one without triangles or with
/// indices out of range. Faces that name a vertex twice, or one that does not exist, are counted and then
/// ignored for the edges. Orientation is judged only for closed and consistent surfaces, shell by shell; a
/// shell that is turned inward is right as a cavity inside another. `unit_m`: length of the vertices' unit in
/// metres.
std::vector<Defect> inspectSurface(const TriangleMesh& mesh, double unit_m = 1);

/// True for defects with which a soft body cannot be simulated: all but slivers, several shells and oddities
/// of files.
bool spoilsBody(DefectKind kind);

/// True for defects with which a tool cannot be used: no triangles, bad vertices or indices, an implausible
/// size, inconsistent orientation. An open surface can be used; it only has no inside.
bool spoilsTool(DefectKind kind);

/// True for a closed surface with outward faces, for which inside and outside are defined.
bool hasInside(const TriangleMesh& mesh);

/// Enclosed volume of a closed, outward surface by the divergence theorem, m^3; negative when inside out.
double signedVolume_m3(const TriangleMesh& mesh);

}  // namespace fissure
