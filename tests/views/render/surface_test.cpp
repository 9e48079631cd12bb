#include "render/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/primitives.h"

namespace fissure::surface_test {

namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

Surface surfaceOf(const TriangleMesh& mesh) {
  return {mesh.faces, static_cast<int>(mesh.vertices_m.size())};
}

TEST(Surface, ClosedMeshHasEachEdgeOnceBetweenTwoFaces) {
  for (const TriangleMesh& mesh : {makeBox({1, 2, 3}), makeSphere(0.03, 2)}) {
    const Surface surface = surfaceOf(mesh);
    EXPECT_EQ(surface.edges().size(), mesh.faces.size() * 3 / 2);
    for (const SurfaceEdge& edge : surface.edges()) {
      EXPECT_LT(edge.a, edge.b);
      EXPECT_GE(edge.face_b, 0);
      EXPECT_NE(edge.face_a, edge.face_b);
    }
  }
}

TEST(Surface, OpenMeshEndsWithoutASecondFace) {
  const Surface surface({{0, 1, 2}}, 3);
  ASSERT_EQ(surface.edges().size(), 3u);
  for (const SurfaceEdge& edge : surface.edges()) {
    EXPECT_EQ(edge.face_b, -1);
  }
}

TEST(CornerNormals, BoxStaysSharpAndSphereIsSmooth) {
  const TriangleMesh box = makeBox({0.04, 0.002, 0.015});
  const Surface box_surface = surfaceOf(box);
  const std::vector<Vec3> flat = box_surface.faceNormals(box.vertices_m);
  const auto corners = box_surface.cornerNormals(box.vertices_m, 50);
  for (std::size_t face = 0; face < flat.size(); ++face) {
    for (const Vec3& normal : corners[face]) {
      EXPECT_NEAR((normal - flat[face]).norm(), 0, 1e-12);
    }
  }
  // 128 triangles: faces turn by about 20 degrees, so all around a vertex count; the mean is the radius
  // within 3 degrees.
  const TriangleMesh sphere = makeSphere(0.03, 2);
  const auto smooth = surfaceOf(sphere).cornerNormals(sphere.vertices_m, 50);
  for (std::size_t face = 0; face < sphere.faces.size(); ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 radius = sphere.vertices_m[sphere.faces[face][corner]].normalized();
      EXPECT_GT(smooth[face][corner].dot(radius), std::cos(6 * M_PI / 180));
    }
  }
}

TEST(CornerNormals, IgnoreFacesThatCannotBeDrawn) {
  TriangleMesh sphere = makeSphere(0.03, 1);
  sphere.vertices_m[0].x() = nan;
  const Surface surface = surfaceOf(sphere);
  const auto normals = surface.cornerNormals(sphere.vertices_m, 60);
  int drawn = 0;
  for (std::size_t face = 0; face < sphere.faces.size(); ++face) {
    if (surface.faceDrawable(sphere.vertices_m, static_cast<int>(face))) {
      ++drawn;
      for (const Vec3& normal : normals[face]) {
        EXPECT_NEAR(normal.norm(), 1, 1e-12);
      }
    }
  }
  EXPECT_EQ(drawn, 32 - 4);  // vertex 0 of the octahedron keeps four faces around it
}

TEST(CutSegments, PlateThroughASphereCutsTwoCircles) {
  // A plate 2 mm thick and wider than the sphere: it crosses the surface in two circles, at y = +1 and -1 mm.
  const double radius_m = 0.03;
  const TriangleMesh sphere = makeSphere(radius_m, 5);
  const TriangleMesh plate = makeBox({0.2, 0.002, 0.2});
  const auto segments = cutSegments(plate.faces, plate.vertices_m, sphere.faces, sphere.vertices_m);
  double length_m = 0;
  for (const auto& [from_m, to_m] : segments) {
    length_m += (to_m - from_m).norm();
    for (const Vec3& point_m : {from_m, to_m}) {
      EXPECT_NEAR(std::abs(point_m.y()), 0.001, 1e-12);
      EXPECT_NEAR(point_m.norm(), radius_m, 2e-3 * radius_m);
    }
  }
  const double circle_m = 2 * M_PI * std::sqrt(radius_m * radius_m - 1e-6);
  EXPECT_NEAR(length_m, 2 * circle_m, 5e-3 * circle_m);
}

TEST(CutSegments, NoneWhereSurfacesDoNotCross) {
  const TriangleMesh sphere = makeSphere(0.03, 3);
  const TriangleMesh inside = makeBox({0.02, 0.002, 0.015});
  EXPECT_TRUE(cutSegments(inside.faces, inside.vertices_m, sphere.faces, sphere.vertices_m).empty());
  TriangleMesh apart = inside;
  for (Vec3& vertex_m : apart.vertices_m) {
    vertex_m.z() += 0.05;
  }
  EXPECT_TRUE(cutSegments(apart.faces, apart.vertices_m, sphere.faces, sphere.vertices_m).empty());
  for (Vec3& vertex_m : apart.vertices_m) {
    vertex_m.x() = nan;
  }
  EXPECT_TRUE(cutSegments(apart.faces, apart.vertices_m, sphere.faces, sphere.vertices_m).empty());
}

}  // namespace
}  // namespace fissure::surface_test
