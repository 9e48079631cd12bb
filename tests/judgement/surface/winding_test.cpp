#include "surface/winding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/primitives.h"
#include "oracles.h"

namespace fissure::winding_test {

namespace {

using test::solidAngleWinding;

TriangleMesh insideOut(TriangleMesh mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

std::vector<TriangleMesh> surfaces() {
  const TriangleMesh sphere = makeSphere(1.0, 2);
  return {sphere,
          insideOut(sphere),
          makeBox({1.0, 1.5, 0.7}),
          test::together(sphere, test::moved(sphere, test::at(0.7, 0.1, 0.0))),
          test::crumpledSphere(1.0, 2, 0.1, 1),
          test::crumpledSphere(1.0, 2, 0.6, 2),
          test::crumpledSphere(1.0, 3, 1.5, 3)};
}

// The crossing number against the sum of solid angles, which must itself be decisive (near an integer).
void expectSameWinding(const TriangleMesh& mesh, const SurfaceTree& tree, const Vec3& point) {
  const double expected = solidAngleWinding(mesh, point);
  ASSERT_NEAR(expected, std::round(expected), 1e-6);
  ASSERT_EQ(windingNumber(tree, SurfaceTree::toTree(point)), std::lround(expected)) << point.transpose();
}

TEST(Winding, EqualsTheSolidAngleSumAtRandomPoints) {
  std::mt19937 random(11);
  for (const TriangleMesh& mesh : surfaces()) {
    const SurfaceTree tree(mesh);
    for (int i = 0; i < 15'000; ++i) expectSameWinding(mesh, tree, test::randomIn(random, 1.6));
  }
}

TEST(Winding, EqualsTheSolidAngleSumNearEdgesAndVertices) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> share(0, 1);
  for (const TriangleMesh& mesh : surfaces()) {
    const SurfaceTree tree(mesh);
    for (int i = 0; i < 2'000; ++i) {
      const Face& face = mesh.faces[random() % mesh.faces.size()];
      const Vec3& a = mesh.vertices_m[static_cast<std::size_t>(face[0])];
      const Vec3& b = mesh.vertices_m[static_cast<std::size_t>(face[1])];
      const double along = i % 4 == 0 ? 0.0 : share(random);
      expectSameWinding(mesh, tree, a + along * (b - a) + test::randomIn(random, 1e-6));
    }
  }
}

// Points whose ray to infinity runs exactly through a vertex: x and y of the tree's frame are the vertex's,
// bit for bit; and through the middle of an edge, as exactly as a double says it.
TEST(Winding, IsRightWhereTheRayMeetsVerticesAndEdges) {
  for (const TriangleMesh& mesh : surfaces()) {
    const SurfaceTree tree(mesh);
    TriangleMesh turned = mesh;
    for (Vec3& vertex : turned.vertices_m) vertex = SurfaceTree::toTree(vertex);
    for (const TreeTriangle& t : tree.triangles()) {
      for (const double below : {0.013, 0.37, 0.91, 1.7, -0.21}) {
        for (const Vec3& through : {t.a, t.b, t.c, Vec3((t.a + t.b) / 2)}) {
          const Vec3 point = through - Vec3(0, 0, below);
          const double expected = solidAngleWinding(turned, point);
          ASSERT_NEAR(expected, std::round(expected), 1e-6);
          ASSERT_EQ(windingNumber(tree, point), std::lround(expected));
        }
      }
    }
  }
}

// A ray along a face: the plane of the face is parallel to z of the tree's frame, and points lie in it,
// beside the face.
TEST(Winding, IsRightForPointsInThePlaneOfAnEdgeOnTriangle) {
  const Mat3 back = SurfaceTree::frame().transpose();
  TriangleMesh box = makeBox({1, 1, 1});
  for (Vec3& vertex : box.vertices_m) vertex = back * vertex;
  const SurfaceTree tree(box);
  std::mt19937 random(13);
  for (int i = 0; i < 5'000; ++i) {
    Vec3 point = test::randomIn(random, 0.49);
    const double out = i % 2 == 0 ? 0.3 : 0.0;  // in the plane of a side face, above or below it: outside
    point.x() = 0.5;
    point.z() = (point.z() > 0 ? 0.5 : -0.5) * (1 + out) + (out > 0 ? 0.0 : (point.z() > 0 ? 1e-3 : -1e-3));
    EXPECT_EQ(windingNumber(tree, point), 0) << point.transpose();
  }
}

TEST(Inverted, NoTriangleOfSphereOrBox) {
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(makeSphere(0.03, 3))), 0);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(makeBox({0.01, 0.02, 0.03}))), 0);
}

TEST(Inverted, EveryTriangleOfAMirroredSphere) {
  TriangleMesh mesh = makeSphere(0.03, 2);
  for (Vec3& vertex : mesh.vertices_m) vertex.x() = -vertex.x();
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(mesh)), 128);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(insideOut(makeSphere(0.03, 2)))), 128);
}

/// A 2 x 2 box, z from 0 to 1, whose top is a fan of four triangles around a vertex at height `tip`.
TriangleMesh boxWithFan(double tip) {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const Vec3& corner : {Vec3(-1, -1, z), Vec3(1, -1, z), Vec3(1, 1, z), Vec3(-1, 1, z)}) {
      mesh.vertices_m.push_back(corner);
    }
  }
  mesh.vertices_m.push_back({0, 0, tip});
  mesh.faces = {{0, 2, 1}, {0, 3, 2}};
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    mesh.faces.push_back({i, j, 4 + j});
    mesh.faces.push_back({i, 4 + j, 4 + i});
    mesh.faces.push_back({4 + i, 4 + j, 8});
  }
  return mesh;
}

// The fan's tip pushed through the bottom; at once its four triangles do, by that corner, whose outer side is
// tissue turned inside out. The fan crosses the bottom on a square of half width |tip| / (1 + |tip|), and the
// bottom's two centroids, 1/3 from the middle, face that from tip = -1/2 on.
TEST(Inverted, CountsAFoldPushedThroughTheFarSide) {
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(boxWithFan(1.0))), 0);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(boxWithFan(0.1))), 0);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(boxWithFan(1e-6))), 0);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(boxWithFan(-0.01))), 4);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(boxWithFan(-0.4))), 4);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(boxWithFan(-1.0))), 6);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(boxWithFan(-5.0))), 6);
}

/// The centroid and a point close by each corner.
std::array<Vec3, 4> placesIn(const TriangleMesh& mesh, const Face& face) {
  const auto corner = [&](std::size_t i) { return mesh.vertices_m[static_cast<std::size_t>(face[i])]; };
  const Vec3 centroid = (corner(0) + corner(1) + corner(2)) / 3;
  std::array<Vec3, 4> places{centroid, {}, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) places[i + 1] = 0.999 * corner(i) + 0.001 * centroid;
  return places;
}

// Two overlapping lobes of one body: buried is each triangle of which the other lobe surrounds the centroid
// or a corner.
TEST(Inverted, CountsTrianglesBuriedInAnotherLobe) {
  const TriangleMesh one = makeSphere(1.0, 3);
  const TriangleMesh other = test::moved(one, {Vec3(0.9, 0.2, 0.1), Quat(0.9, 0.1, 0.3, 0.2).normalized()});
  int expected = 0;
  for (const auto& [lobe, around] : {std::pair(one, other), std::pair(other, one)}) {
    for (const Face& face : lobe.faces) {
      const std::array<Vec3, 4> places = placesIn(lobe, face);
      expected += std::any_of(places.begin(), places.end(),
                              [&](const Vec3& place) { return solidAngleWinding(around, place) > 0.5; });
    }
  }
  ASSERT_GT(expected, 50);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(test::together(one, other))), expected);
}

TEST(Inverted, EqualsTheSolidAngleJustBeneathCentroidAndCorners) {
  for (const double noise : {0.05, 0.3, 0.6, 1.5}) {
    const TriangleMesh mesh = test::crumpledSphere(1.0, 2, noise, 5);
    int expected = 0;
    for (const Face& face : mesh.faces) {
      const auto corner = [&](std::size_t i) { return mesh.vertices_m[static_cast<std::size_t>(face[i])]; };
      const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
      const std::array<Vec3, 4> places = placesIn(mesh, face);
      expected += std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
        return std::lround(solidAngleWinding(mesh, place - 1e-8 * normal)) != 1;
      });
    }
    EXPECT_EQ(countInvertedTriangles(SurfaceTree(mesh)), expected) << noise;
  }
}

TEST(Inverted, LeavesTrianglesWithoutAreaOut) {
  TriangleMesh flat = makeBox({1, 1, 1});
  for (Vec3& vertex : flat.vertices_m) vertex = Vec3(0.1, 0.2, 0.3);
  EXPECT_EQ(countInvertedTriangles(SurfaceTree(flat)), 0);
}

}  // namespace
}  // namespace fissure::winding_test
