#include "scene/place.h"

#include "mesh/file_surface.h"
#include "mesh/lobes.h"
#include "mesh/primitives.h"

namespace fissure {
namespace {

using Folder = std::filesystem::path;

TriangleMesh makeShape(const SphereShape& sphere, const Folder&) {
  return makeSphere(sphere.radius_m, sphere.subdivisions);
}
TriangleMesh makeShape(const BoxShape& box, const Folder&) {
  return makeBox(box.size_m);
}
TriangleMesh makeShape(const CapsuleShape& capsule, const Folder&) {
  return makeCapsule(capsule.radius_m, capsule.length_m, capsule.subdivisions,
                     static_cast<int>(capsule.rows()));
}
TriangleMesh makeShape(const TrianglesShape& given, const Folder&) {
  return {given.vertices_m, given.faces};
}
TriangleMesh makeShape(const LobesShape& shape, const Folder&) {
  return makeLobes(shape);
}
TriangleMesh makeShape(const FileShape& shape, const Folder& directory) {
  return loadSurface(shape, directory).mesh;
}

}  // namespace

TriangleMesh makeSurface(const SurfaceShape& shape, const Folder& directory) {
  return std::visit([&](const auto& alternative) { return makeShape(alternative, directory); }, shape);
}

TriangleMesh placeBody(const BodySettings& body, const Folder& directory) {
  return placeBody(body, makeSurface(body.shape, directory));
}

TriangleMesh placeBody(const BodySettings& body, TriangleMesh shape) {
  // Written quaternions are rounded: without this a body would shrink or grow by the rounding.
  const Pose pose{body.position_m, body.orientation.normalized()};
  for (Vec3& vertex : shape.vertices_m) vertex = pose.toScene(vertex);
  return shape;
}

}  // namespace fissure
