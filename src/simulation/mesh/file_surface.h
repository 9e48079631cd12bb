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

/// A surface from a file, with its defects and repairs.
struct FileSurface {
  TriangleMesh mesh;                 ///< metres, in the file's frame; repaired and subdivided as asked
  std::vector<Defect> found;         ///< defects in the file, after welding
  std::vector<std::string> repairs;  ///< changes by repairs, one line each (repairMesh)
  std::vector<Defect> left;          ///< defects that remain in `mesh`, and oddities of the file
};

/// Reads a file, scales it to metres, welds, inspects, repairs and subdivides it as `shape` asks; `directory`
/// is the folder of a relative name. Nothing is repaired where a vertex is not finite. Throws InputError for
/// a file that is no mesh (readMeshFile) and for a `max_edge_m` that makes more than 131,072 triangles.
/// Defects throw nothing: see spoilsBody and spoilsTool.
FileSurface loadSurface(const FileShape& shape, const std::filesystem::path& directory);

/// A cache of surfaces from mesh files: each file is read once, when it is first asked for.
class SurfaceFiles {
 public:
  /// `directory`: the folder of relative file names.
  explicit SurfaceFiles(std::filesystem::path directory) : directory_(std::move(directory)) {}

  /// As loadSurface, and throws as it does. The reference is valid as long as this object.
  const FileSurface& surface(const FileShape& shape) const;

 private:
  std::filesystem::path directory_;
  mutable std::map<std::filesystem::path, FileMesh> meshes_;  ///< the files as read
  mutable std::list<std::pair<FileShape, FileSurface>> surfaces_;
};

}  // namespace fissure
