#include "scene/place.h"

#include "mesh/lobes.h"
#include "mesh/primitives.h"
#include "mesh/tetrahedra.h"
#include "scene/fixed_vertices.h"
#include "scene/volume_regions.h"

namespace fissure {
namespace {

TriangleMesh makeShape(const SphereShape& sphere, const MeshFiles&) {
  return makeSphere(sphere.radius_m, sphere.subdivisions);
}
TriangleMesh makeShape(const BoxShape& box, const MeshFiles&) {
  return makeBox(box.size_m, box.cells);
}
TriangleMesh makeShape(const CapsuleShape& capsule, const MeshFiles&) {
  return makeCapsule(capsule.radius_m, capsule.length_m, capsule.subdivisions,
                     static_cast<int>(capsule.rows()));
}
TriangleMesh makeShape(const TrianglesShape& given, const MeshFiles&) {
  return {given.vertices_m, given.faces};
}
TriangleMesh makeShape(const LobesShape& shape, const MeshFiles&) {
  return makeLobes(shape);
}
TriangleMesh makeShape(const FileShape& shape, const MeshFiles& files) {
  return files.surface(shape).mesh;
}
TriangleMesh makeShape(const TetrahedraShape& shape, const MeshFiles& files) {
  return files.volume(shape).surface;
}

/// The inside of an elastic body in the shape's own frame.
TetrahedralMesh makeVolume(const BodySettings& body, const MeshFiles& files) {
  if (body.isFilledByMesher()) return files.filled(body).mesh;
  if (const auto* from_file = std::get_if<TetrahedraShape>(&body.shape)) return files.volume(*from_file).mesh;
  return makeTetrahedra(body.shape).value();
}

void moveTo(const BodySettings& body, std::vector<Vec3>& vertices_m) {
  // Written quaternions are rounded: without this a body would shrink or grow by the rounding.
  const Pose pose{body.position_m, body.orientation.normalized()};
  for (Vec3& vertex_m : vertices_m) vertex_m = pose.toScene(vertex_m);
}

}  // namespace

TriangleMesh makeSurface(const SurfaceShape& shape, const MeshFiles& files) {
  return std::visit([&](const auto& alternative) { return makeShape(alternative, files); }, shape);
}

TriangleMesh placeBody(const BodySettings& body, const MeshFiles& files) {
  TriangleMesh placed = body.isFilledByMesher() ? files.filled(body).surface : makeSurface(body.shape, files);
  moveTo(body, placed.vertices_m);
  return placed;
}

SceneVolume placeVolume(const BodySettings& body, const MeshFiles& files) {
  SceneVolume volume{.mesh = makeVolume(body, files), .fixed_vertices = {}};
  volume.regions = volumeRegions(body, volume.mesh);
  moveTo(body, volume.mesh.vertices_m);
  volume.fixed_vertices = fixedVertices(body, volume.mesh.vertices_m);
  return volume;
}

}  // namespace fissure
