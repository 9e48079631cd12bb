#pragma once

#include <filesystem>
#include <vector>

#include "base/geometry.h"
#include "mesh/check.h"

namespace fissure {

/// The contents of a mesh file.
struct FileMesh {
  TriangleMesh mesh;
  /// Oddities of the file that its triangles do not show: unused vertices and non-planar polygons. The texts
  /// name the first of each.
  std::vector<Defect> oddities;
};

/// Reads the surface in an STL, OBJ, PLY or OFF file (by its ending) with Assimp: the file's own numbers in
/// single precision, all parts together, polygons split into triangles. Nothing is merged or moved, so equal
/// vertices come as often as in the file; Assimp drops OBJ vertices that no face names. Materials are
/// ignored, and no other file is opened, whatever the mesh names. Throws InputError about a file that is
/// missing, empty or a folder, is not of the format of its ending, is larger than 256 MiB or 2^20 triangles,
/// states counts that it cannot hold, has no faces, has faces of fewer than three corners or with corners
/// that do not exist, or that Assimp rejects. Throws RunError when Assimp is not installed. Assimp may crash
/// or loop on a damaged file: try a file of unknown origin in a child process first (doApart).
FileMesh readMeshFile(const std::filesystem::path& file);

}  // namespace fissure
