#include "mesh/place.h"

#include "mesh/primitives.h"

namespace fissure {
namespace {

TriangleMesh makeShape(const SphereShape& sphere) {
  return makeSphere(sphere.radius_m, sphere.subdivisions);
}
TriangleMesh makeShape(const BoxShape& box) {
  return makeBox(box.size_m);
}
TriangleMesh makeShape(const TrianglesShape& given) {
  return {given.vertices_m, given.faces};
}

}  // namespace

TriangleMesh placeBody(const BodySettings& body) {
  TriangleMesh mesh = std::visit([](const auto& shape) { return makeShape(shape); }, body.shape);
  // Written quaternions are rounded: without this a body would shrink or grow by the rounding.
  const Pose pose{body.position_m, body.orientation.normalized()};
  for (Vec3& vertex : mesh.vertices_m) vertex = pose.toScene(vertex);
  return mesh;
}

}  // namespace fissure
