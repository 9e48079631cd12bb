#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

/// A volume with the surface that bounds it.
struct BoundedVolume {
  TriangleMesh surface;  ///< outward faces
  TetrahedralMesh mesh;  ///< its first vertices are the surface's
  /// What was odd and what was done about it, a line each, for people.
  std::vector<std::string> notes = {};
};

/// The tetrahedra in a file: Gmsh's .msh (2 and 4) or VTK's .vtk, text or binary, as its ending says, read by
/// meshio in a process of its own. The file's own numbers times `unit_m`. Tags are Gmsh's physical groups, or
/// cell data named region, tag or material. Of quadratic tetrahedra the corners alone; tetrahedra of negative
/// volume are turned, vertices of none are dropped; each is noted. Other cells than points, lines, triangles
/// and tetrahedra are refused. Throws InputError about `file`: missing, empty, larger than 256 MiB, damaged,
/// without tetrahedra or with more than 2,097,152. RunError where python3-meshio is not installed.
BoundedVolume readTetrahedra(const std::filesystem::path& file, double unit_m);

/// Puts the vertices of the boundary first, in their order, and drops those that no tetrahedron has; turns
/// tetrahedra of negative volume. Notes both. All corners must exist.
BoundedVolume boundedBySurface(TetrahedralMesh mesh);

}  // namespace fissure
