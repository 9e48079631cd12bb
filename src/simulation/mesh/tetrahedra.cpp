#include "mesh/tetrahedra.h"

#include "mesh/ball_tetrahedra.h"
#include "mesh/box_grid.h"
#include "mesh/capsule_tetrahedra.h"
#include "mesh/hexahedron.h"
#include "mesh/lobes.h"
#include "mesh/tetrahedron_faces.h"

namespace fissure {
namespace {

using Volume = std::optional<TetrahedralMesh>;

Volume volumeOf(const SphereShape& sphere) {
  return makeBallTetrahedra(sphere.radius_m, sphere.subdivisions).mesh;
}
Volume volumeOf(const BoxShape& box) {
  return makeBoxTetrahedra(box.size_m, box.cells);
}
Volume volumeOf(const CapsuleShape& capsule) {
  return makeCapsuleTetrahedra(capsule.radius_m, capsule.length_m, capsule.subdivisions,
                               static_cast<int>(capsule.rows()));
}
Volume volumeOf(const LobesShape& lobes) {
  return makeLobesTetrahedra(lobes);
}
Volume volumeOf(const TrianglesShape&) {
  return std::nullopt;
}
Volume volumeOf(const FileShape&) {
  return std::nullopt;
}
Volume volumeOf(const TetrahedraShape&) {
  return std::nullopt;
}

}  // namespace

std::optional<TetrahedralMesh> makeTetrahedra(const SurfaceShape& shape) {
  return std::visit([](const auto& one) { return volumeOf(one); }, shape);
}

TetrahedralMesh makeBoxTetrahedra(const Vec3& size_m, const std::array<int, 3>& cells) {
  const BoxGrid grid(cells);
  TetrahedralMesh box;
  for (const auto* points : {&grid.surface(), &grid.inside()})
    for (const GridPoint& point : *points) box.vertices_m.push_back(grid.position_m(point, size_m));
  for (int k = 0; k < cells[2]; ++k) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int i = 0; i < cells[0]; ++i) {
        std::array<int, 8> corners{};
        for (int corner = 0; corner < 8; ++corner)
          corners[static_cast<std::size_t>(corner)] =
              grid.index({i + (corner & 1), j + ((corner >> 1) & 1), k + ((corner >> 2) & 1)});
        const auto start = static_cast<unsigned>(i % 2 + 2 * (j % 2) + 4 * (k % 2));
        addKuhnTetrahedra(corners, start, box.tetrahedra);
      }
    }
  }
  return box;
}

std::vector<Face> boundaryFaces(const TetrahedralMesh& mesh) {
  std::vector<Face> boundary;
  forEachFace(tetrahedronFaces(mesh.tetrahedra, mesh.vertices_m.size()), [&](auto first, auto last) {
    if (last - first == 1) boundary.push_back(first->outward);
  });
  return boundary;
}

}  // namespace fissure
