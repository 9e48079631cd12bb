#include "surface/distance.h"

#include <gtest/gtest.h>

#include "measure/tool_shape.h"
#include "mesh/primitives.h"
#include "slow_penetration.h"
#include "surface/oracles.h"

namespace fissure::distance_test {

namespace {

TEST(Distance, EqualsBruteForce) {
  std::mt19937 random(21);
  for (const TriangleMesh& mesh :
       {makeSphere(1.0, 3), makeBox({1.0, 0.02, 0.5}), test::crumpledSphere(1.0, 2, 0.8, 4)}) {
    const SurfaceTree tree(mesh);
    for (int i = 0; i < 3'000; ++i) {
      const Vec3 point = test::randomIn(random, 1.5);
      ASSERT_NEAR(distance_m(tree, SurfaceTree::toTree(point)), test::bruteDistance(mesh, point), 1e-13);
    }
  }
}

// Alone, so that no neighbour stands in for an edge or a corner.
TEST(Distance, OfASingleTriangleEqualsThatInItsOwnPlane) {
  std::mt19937 random(26);
  for (int i = 0; i < 20'000; ++i) {
    const TreeTriangle t{test::randomIn(random, 1), test::randomIn(random, 1), test::randomIn(random, 1)};
    const TriangleMesh mesh{{t.a, t.b, t.c}, {{0, 1, 2}}};
    const Vec3 point = test::randomIn(random, i % 2 == 0 ? 1.0 : 3.0);
    ASSERT_NEAR(std::sqrt(distanceSquared(t, point)), test::planarDistance_m(mesh, point), 1e-12);
  }
}

// Slivers: a corner 1e-9 away from the opposite edge of length 1, and triangles without area.
TEST(Distance, HoldsForSliversAndDegenerateTriangles) {
  std::mt19937 random(22);
  const Vec3 a(0, 0, 0), b(1, 0, 0);
  for (const Vec3& c :
       {Vec3(0.3, 1e-9, 0), Vec3(0.3, 0, 0), Vec3(1, 0, 0), Vec3(2, 1e-14, 0), Vec3(1e-9, 1, 0)}) {
    const TriangleMesh mesh{{a, b, c}, {{0, 1, 2}}};
    for (int i = 0; i < 1'000; ++i) {
      const Vec3 point = test::randomIn(random, 2.0);
      const double expected = test::bruteDistance(mesh, point);
      ASSERT_NEAR(std::sqrt(distanceSquared({a, b, c}, point)), expected, 1e-8) << c.transpose();
    }
  }
}

TEST(Distance, StopsEarlyOnlyAsAllowed) {
  std::mt19937 random(23);
  const TriangleMesh mesh = makeSphere(1.0, 3);
  const SurfaceTree tree(mesh);
  for (int i = 0; i < 2'000; ++i) {
    const Vec3 point = SurfaceTree::toTree(test::randomIn(random, 1.5));
    const double exact = distance_m(tree, point);
    const double limited = distance_m(tree, point, {.limit_m = 0.2});
    EXPECT_EQ(limited, exact < 0.2 ? exact : std::numeric_limits<double>::infinity());
    const double enough = distance_m(tree, point, {.enough_m = 0.2});
    if (exact > 0.2) {
      EXPECT_EQ(enough, exact);
    } else {
      EXPECT_LE(enough, 0.2);
      EXPECT_GE(enough, exact);
    }
  }
}

TEST(Distance, FollowsVerticesThatMove) {
  std::mt19937 random(24);
  const TriangleMesh rest = makeSphere(1.0, 2);
  const TriangleMesh now = test::crumpledSphere(1.0, 2, 1.0, 6);
  SurfaceTree tree(rest);
  tree.update(now.vertices_m);
  for (int i = 0; i < 1'000; ++i) {
    const Vec3 point = test::randomIn(random, 1.5);
    ASSERT_NEAR(distance_m(tree, SurfaceTree::toTree(point)), test::bruteDistance(now, point), 1e-13);
  }
}

// The same box as a box and as a surface of triangles.
TEST(ToolShape, TrianglesAndBoxAgree) {
  std::mt19937 random(25);
  const Vec3 size(0.04, 0.002, 0.015);
  SceneTool box{.name = "box", .surface = makeBox(size), .box_size_m = size};
  SceneTool triangles{.name = "triangles", .surface = makeBox(size)};
  const ToolShape one(box), other(triangles);
  constexpr double far = std::numeric_limits<double>::infinity();
  int inside = 0;
  for (int i = 0; i < 5'000; ++i) {
    const Vec3 point = test::randomIn(random, 1.0).cwiseProduct(size);
    const double distance = one.signedDistance_m(point, far);
    inside += distance < 0;
    ASSERT_NEAR(distance, other.signedDistance_m(point, far), 1e-15);
  }
  EXPECT_GT(inside, 300);
  EXPECT_DOUBLE_EQ(one.signedDistance_m({0, 0.0004, 0}, far), -0.0006);
  EXPECT_DOUBLE_EQ(one.signedDistance_m({0.023, 0.005, 0}, far), 0.005);  // 3 mm and 4 mm beyond an edge
}

TEST(ToolShape, ASurfaceThatIsOpenHasNoInside) {
  SceneTool open{.name = "sheet", .surface = makeBox({1, 1, 1}), .closed = false};
  open.surface.faces.pop_back();
  EXPECT_DOUBLE_EQ(ToolShape(open).signedDistance_m({0.1, 0, 0}, 1), 0.4);
}

}  // namespace
}  // namespace fissure::distance_test
