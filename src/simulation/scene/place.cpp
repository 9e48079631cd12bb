#include "scene/place.h"

#include "mesh/lobes.h"
#include "mesh/primitives.h"
#include "mesh/tetrahedra.h"
#include "scene/fixed_vertices.h"

namespace fissure {
namespace {

TriangleMesh makeShape(const SphereShape& sphere, const SurfaceFiles&) {
  return makeSphere(sphere.radius_m, sphere.subdivisions);
}
TriangleMesh makeShape(const BoxShape& box, const SurfaceFiles&) {
  return makeBox(box.size_m, box.cells);
}
TriangleMesh makeShape(const CapsuleShape& capsule, const SurfaceFiles&) {
  return makeCapsule(capsule.radius_m, capsule.length_m, capsule.subdivisions,
                     static_cast<int>(capsule.rows()));
}
TriangleMesh makeShape(const TrianglesShape& given, const SurfaceFiles&) {
  return {given.vertices_m, given.faces};
}
TriangleMesh makeShape(const LobesShape& shape, const SurfaceFiles&) {
  return makeLobes(shape);
}
TriangleMesh makeShape(const FileShape& shape, const SurfaceFiles& files) {
  return files.surface(shape).mesh;
}

void moveTo(const BodySettings& body, std::vector<Vec3>& vertices_m) {
  // Written quaternions are rounded: without this a body would shrink or grow by the rounding.
  const Pose pose{body.position_m, body.orientation.normalized()};
  for (Vec3& vertex_m : vertices_m) vertex_m = pose.toScene(vertex_m);
}

}  // namespace

TriangleMesh makeSurface(const SurfaceShape& shape, const SurfaceFiles& files) {
  return std::visit([&](const auto& alternative) { return makeShape(alternative, files); }, shape);
}

TriangleMesh placeBody(const BodySettings& body, const SurfaceFiles& files) {
  TriangleMesh placed = makeSurface(body.shape, files);
  moveTo(body, placed.vertices_m);
  return placed;
}

SceneVolume placeVolume(const BodySettings& body) {
  SceneVolume volume{.mesh = makeTetrahedra(body.shape).value(), .fixed_vertices = {}};
  moveTo(body, volume.mesh.vertices_m);
  volume.fixed_vertices = fixedVertices(body, volume.mesh.vertices_m);
  return volume;
}

}  // namespace fissure
