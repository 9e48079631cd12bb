#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "mesh/check.h"
#include "scenario/shapes.h"

namespace fissure {

/// A surface from a file, with what was wrong with it and what was done about that.
struct FileSurface {
  TriangleMesh mesh;                 ///< metres, in the file's frame; repaired and subdivided as asked
  std::vector<Defect> found;         ///< in the file, welded
  std::vector<std::string> repairs;  ///< what they changed (repairMesh)
  std::vector<Defect> left;          ///< in `mesh`
};

/// Reads, scales, welds, inspects, repairs and subdivides. Repairs are left out where a vertex is not finite.
/// Throws InputError for a file that is no mesh (readMeshFile) and for a `max_edge_m` that makes more than
/// 131,072 triangles. Defects throw nothing: see spoilsBody and spoilsTool.
FileSurface loadSurface(const FileShape& shape, const std::filesystem::path& directory);

}  // namespace fissure
