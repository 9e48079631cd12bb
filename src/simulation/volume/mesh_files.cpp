#include "volume/mesh_files.h"

#include "base/error.h"
#include "volume/tetgen.h"

namespace fissure {

namespace {

/// The value kept for `key`, made by `make` where there is none yet.
template <class Key, class Make>
const BoundedVolume& kept(std::list<std::pair<Key, BoundedVolume>>& volumes, const Key& key,
                          const Make& make) {
  for (const auto& [known, volume] : volumes)
    if (known == key) return volume;
  return volumes.emplace_back(key, make()).second;
}

}  // namespace

const BoundedVolume& MeshFiles::volume(const TetrahedraShape& shape) const {
  return kept(volumes_, shape, [&] { return readTetrahedra(directory_ / shape.file, metres(shape.unit)); });
}

const BoundedVolume& MeshFiles::filled(const BodySettings& body) const {
  const FillSettings settings = body.elastic.fill.value_or(FillSettings());
  return kept(filled_, std::pair(body.shape, settings), [&] {
    const auto* from_file = std::get_if<FileShape>(&body.shape);
    const auto* given = std::get_if<TrianglesShape>(&body.shape);
    try {
      return fillWithTetrahedra(
          from_file ? surface(*from_file).mesh : TriangleMesh{given->vertices_m, given->faces}, settings);
    } catch (const InputError& error) {
      throw InputError("bodies." + body.name + ".shape: " + error.what());
    } catch (const RunError& error) {
      throw RunError("bodies." + body.name + ".shape: " + error.what());
    }
  });
}

}  // namespace fissure
