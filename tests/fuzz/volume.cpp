#include <set>

#include "target.h"
#include "volume/tetrahedra_file.h"

namespace fissure::fuzz {

/// What the script of meshio writes, damaged: the volume's own reader of it.
void takeVolume(const std::string& bytes) {
  const std::filesystem::path file = scratch() / "fuzzed.msh";
  BoundedVolume volume;
  if (!accepts(file, Refusal::own_file, [&] { volume = unpackedTetrahedra(bytes, file, 1e-3); })) return;
  const auto vertices = static_cast<int>(volume.mesh.vertices_m.size());
  require(
      !volume.mesh.tetrahedra.empty() && volume.surface.vertices_m.size() <= volume.mesh.vertices_m.size(),
      "a volume has tetrahedra");
  std::set<int> used;
  for (const Tetrahedron& tetrahedron : volume.mesh.tetrahedra)
    for (const int v : tetrahedron) {
      require(v >= 0 && v < vertices, "corners exist");
      used.insert(v);
    }
  require(static_cast<int>(used.size()) == vertices, "every vertex is a corner");
  for (const Face& face : volume.surface.faces)
    for (const int v : face)
      require(v >= 0 && v < static_cast<int>(volume.surface.vertices_m.size()),
              "corners of the surface exist");
  require(volume.mesh.tags.empty() || volume.mesh.tags.size() == volume.mesh.tetrahedra.size(),
          "tags are all or none");
}

}  // namespace fissure::fuzz
