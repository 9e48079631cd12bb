#pragma once

#include <filesystem>
#include <list>
#include <utility>

#include "mesh/file_surface.h"
#include "scenario/bodies.h"
#include "volume/tetrahedra_file.h"

namespace fissure {

/// A cache of the surfaces and volumes of a scenario's shapes: each file is read once and each surface filled
/// once, when it is first asked for. References are valid as long as this object.
class MeshFiles {
 public:
  /// `directory`: the folder of relative file names.
  explicit MeshFiles(const std::filesystem::path& directory) : directory_(directory), surfaces_(directory) {}

  /// The surface in a file, in metres; throws as loadSurface.
  const FileSurface& surface(const FileShape& shape) const { return surfaces_.surface(shape); }

  /// The volume in a file, in metres; throws as readTetrahedra.
  const BoundedVolume& volume(const TetrahedraShape& shape) const;

  /// The volume of an elastic body whose shape is only a surface, in the shape's own frame. Throws as
  /// fillWithTetrahedra, with "bodies.<name>.shape: " before the message.
  const BoundedVolume& filled(const BodySettings& body) const;

 private:
  std::filesystem::path directory_;
  SurfaceFiles surfaces_;
  mutable std::list<std::pair<TetrahedraShape, BoundedVolume>> volumes_;
  mutable std::list<std::pair<std::pair<SurfaceShape, FillSettings>, BoundedVolume>> filled_;
};

}  // namespace fissure
