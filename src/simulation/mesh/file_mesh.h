#pragma once

#include <filesystem>
#include <vector>

#include "base/geometry.h"
#include "mesh/check.h"

namespace fissure {

/// What a mesh file holds.
struct FileMesh {
  TriangleMesh mesh;
  /// What is odd about the file that its triangles do not show: unused vertices and non-planar polygons, each
  /// with the first of them.
  std::vector<Defect> oddities;
};

/// The surface in an STL, OBJ, PLY or OFF file (by its ending), read by Assimp: the file's own numbers, in
/// single precision as Assimp keeps them, all its parts together, polygons split into triangles. Nothing else
/// is merged, moved or left out, so that equal vertices come as often as the file has them; Assimp drops OBJ
/// vertices that no face names, and materials are not looked at. No other file is opened, whatever the
/// mesh names.
/// Throws InputError about `file`: missing, empty, a folder, another format than its ending says, larger than
/// 256 MiB or 2^20 triangles, counts that it cannot hold, faces of fewer than three corners or with corners
/// that do not exist, no faces, anything that Assimp finds wrong. Assimp may also crash on a damaged file, or
/// never end: read a file of unknown origin in a process of its own first. RunError when Assimp is not
/// installed.
FileMesh readMeshFile(const std::filesystem::path& file);

}  // namespace fissure
