#pragma once

#include <filesystem>
#include <list>
#include <utility>

#include "mesh/file_surface.h"
#include "scenario/bodies.h"
#include "volume/tetrahedra_file.h"

namespace fissure {

/// The surfaces and volumes behind a scenario's shapes: each file read once, each surface filled once, when
/// somebody first asks for it. References hold as long as this object.
class MeshFiles {
 public:
  /// `directory`: where relative file names start.
  explicit MeshFiles(const std::filesystem::path& directory) : directory_(directory), surfaces_(directory) {}

  /// As loadSurface, which says what is thrown.
  const FileSurface& surface(const FileShape& shape) const { return surfaces_.surface(shape); }

  /// As readTetrahedra.
  const BoundedVolume& volume(const TetrahedraShape& shape) const;

  /// The inside of an elastic body whose shape is a surface alone, in the shape's own frame. As
  /// fillWithTetrahedra, with "bodies.<name>.shape: " before what is wrong.
  const BoundedVolume& filled(const BodySettings& body) const;

 private:
  std::filesystem::path directory_;
  SurfaceFiles surfaces_;
  mutable std::list<std::pair<TetrahedraShape, BoundedVolume>> volumes_;
  mutable std::list<std::pair<std::pair<SurfaceShape, FillSettings>, BoundedVolume>> filled_;
};

}  // namespace fissure
