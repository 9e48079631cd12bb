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
  /// Oddities of the mesh and how they were corrected, one line each, for people.
  std::vector<std::string> notes = {};
};

/// Reads tetrahedra from a Gmsh .msh (formats 2 and 4) or VTK .vtk file, text or binary, chosen by its
/// ending, by meshio in a process of its own (elastic/METHOD.md 9). Coordinates are the file's numbers times
/// `unit_m`. Tags are Gmsh's physical groups, or cell data named region, tag or material. Quadratic
/// tetrahedra are reduced to their corners, tetrahedra of negative volume are turned, and vertices of no
/// tetrahedron are dropped; all this is noted. Other cells than points, lines, triangles and tetrahedra are
/// refused. Throws InputError about a file that is missing, empty, larger than 256 MiB, damaged, without
/// tetrahedra or with more than 2,097,152 of them, and RunError where python3-meshio is not installed.
BoundedVolume readTetrahedra(const std::filesystem::path& file, double unit_m);

/// The same from what that process writes (read_tetrahedra.py). `file` appears in messages.
BoundedVolume unpackedTetrahedra(const std::string& output, const std::filesystem::path& file, double unit_m);

/// Puts the vertices of the boundary first, in their order, drops vertices of no tetrahedron and turns
/// tetrahedra of negative volume, with notes about the latter two. All corners must be valid indices.
BoundedVolume boundedBySurface(TetrahedralMesh mesh);

}  // namespace fissure
