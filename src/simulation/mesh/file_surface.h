#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/geometry.h"
#include "mesh/check.h"
#include "mesh/file_mesh.h"
#include "scenario/shapes.h"

namespace fissure {

/// A surface from a file, with what was wrong with it and what was done about that.
struct FileSurface {
  TriangleMesh mesh;                 ///< metres, in the file's frame; repaired and subdivided as asked
  std::vector<Defect> found;         ///< in the file, welded
  std::vector<std::string> repairs;  ///< what they changed (repairMesh)
  std::vector<Defect> left;          ///< in `mesh`, and what is odd about the file
};

/// Reads, scales, welds, inspects, repairs and subdivides. Repairs are left out where a vertex is not finite.
/// Throws InputError for a file that is no mesh (readMeshFile) and for a `max_edge_m` that makes more than
/// 131,072 triangles. Defects throw nothing: see spoilsBody and spoilsTool.
FileSurface loadSurface(const FileShape& shape, const std::filesystem::path& directory);

/// The surfaces of the mesh files in one directory, each file read once: when the first shape asks for it.
class SurfaceFiles {
 public:
  /// `directory`: where relative file names start.
  explicit SurfaceFiles(std::filesystem::path directory) : directory_(std::move(directory)) {}

  /// As loadSurface, which says what is thrown. The reference holds as long as this object.
  const FileSurface& surface(const FileShape& shape) const;

 private:
  std::filesystem::path directory_;
  mutable std::map<std::filesystem::path, FileMesh> meshes_;  ///< as read
  mutable std::list<std::pair<FileShape, FileSurface>> surfaces_;
};

}  // namespace fissure
