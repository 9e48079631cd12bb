#include "contact/vertex_sides.h"

#include <gtest/gtest.h>

#include "mesh/primitives.h"

namespace fissure::vertex_sides_test {

namespace {

constexpr double kMargin_m = 0.001;

/// One vertex (the others are far away) and a plate of 80 x 5 x 80 mm around the origin that does not turn.
class VertexSidesTest : public testing::Test {
 protected:
  VertexSidesTest() {
    TriangleMesh far = makeBox({0.01, 0.01, 0.01});
    for (Vec3& v : far.vertices_m) v += Vec3(1, 1, 1);
    scene.bodies.push_back({.name = "tissue", .rest = far});
    scene.tools.push_back({.name = "plate", .surface = {}, .box_size_m = Vec3(0.08, 0.005, 0.08)});
    before = now = far.vertices_m;
    sides.emplace(scene, std::vector<double>{kMargin_m});
  }

  /// Vertex 0 goes to `point` while the plate's middle goes from height `from` to `to`.
  const std::vector<ContactConstraint>& moveVertex(const Vec3& point, double from = 0, double to = 0) {
    before = now;
    now[0] = point;
    found.clear();
    const std::vector<ToolState> was = {{.pose = {.position_m = Vec3(0, from, 0)}}};
    const std::vector<ToolState> is = {{.pose = {.position_m = Vec3(0, to, 0)}}};
    sides->find({.positions_m = now, .before_m = before, .tools_before = was, .tools_now = is}, {}, found);
    return found;
  }

  Scene scene;
  std::optional<VertexSides> sides;
  std::vector<Vec3> before, now;
  std::vector<ContactConstraint> found;
};

TEST_F(VertexSidesTest, AVertexInFrontOfTheMarginIsFree) {
  moveVertex({0, -0.02, 0});
  EXPECT_TRUE(moveVertex({0, -0.0025 - kMargin_m - 1e-9, 0}).empty());
}

TEST_F(VertexSidesTest, AVertexIsHeldInFrontOfTheFaceItCameFrom) {
  moveVertex({0.01, -0.02, 0});
  ASSERT_EQ(moveVertex({0.01, 0.001, 0}).size(), 1u) << "past the middle of the plate in one step";
  EXPECT_EQ(found[0].normal, Vec3(0, -1, 0)) << "from the tool to the side it came from";
  EXPECT_EQ(found[0].vertices[0], 0);
  EXPECT_EQ(found[0].position_m, Vec3(0, -0.0025, 0));
  EXPECT_EQ(found[0].target_m, kMargin_m);
}

TEST_F(VertexSidesTest, AVertexThatStartsWithinTheMarginIsOnTheNearestSide) {
  now[0] = Vec3(0, 0.0025 + 0.5 * kMargin_m, 0);
  ASSERT_EQ(moveVertex({0, 0.001, 0}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, 1, 0));
}

TEST_F(VertexSidesTest, AVertexThatStaysInsideKeepsItsSide) {
  moveVertex({0, -0.02, 0});
  moveVertex({0, -0.001, 0});
  for (const double y : {0.0005, 0.002, 0.0024}) {
    ASSERT_EQ(moveVertex({0, y, 0}).size(), 1u);
    EXPECT_EQ(found[0].normal, Vec3(0, -1, 0)) << "though the other face is nearer at y = " << y;
  }
}

TEST_F(VertexSidesTest, AVertexThatCrossesTheWholePlateInOneStepIsBroughtBack) {
  moveVertex({0, -0.02, 0});
  ASSERT_EQ(moveVertex({0, 0.02, 0}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, -1, 0));
}

TEST_F(VertexSidesTest, ThePlatesOwnMotionCounts) {
  // The vertex rests; the plate comes down through it from 20 mm above to 20 mm below.
  moveVertex({0, 0, 0}, 0.02, 0.02);
  ASSERT_EQ(moveVertex({0, 0, 0}, 0.02, -0.02).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, -1, 0)) << "the lower face met it";
  EXPECT_EQ(found[0].position_m, Vec3(0, -0.0225, 0));
}

TEST_F(VertexSidesTest, EntersThroughANarrowFaceToo) {
  moveVertex({0.06, 0, 0});
  ASSERT_EQ(moveVertex({0.038, 0, 0}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(1, 0, 0));
}

TEST_F(VertexSidesTest, PassingBesideThePlateIsNoContact) {
  moveVertex({0.06, -0.02, 0});
  EXPECT_TRUE(moveVertex({0.06, 0.02, 0}).empty());
  EXPECT_TRUE(moveVertex({0.02, 0.02, 0}).empty()) << "over it";
}

TEST_F(VertexSidesTest, WhatStartsInsideHasNoSide) {
  now[0] = Vec3(0, 0.001, 0);
  EXPECT_TRUE(moveVertex({0, 0.0005, 0}).empty());
  moveVertex({0, 0.02, 0});
  EXPECT_EQ(moveVertex({0, 0.001, 0}).size(), 1u) << "once out, it has one";
}

TEST_F(VertexSidesTest, LeavingForgetsTheSide) {
  moveVertex({0, -0.02, 0});
  moveVertex({0, -0.001, 0});
  moveVertex({0, -0.02, 0});
  moveVertex({0.06, -0.02, 0});
  moveVertex({0.06, 0.02, 0});
  moveVertex({0, 0.02, 0});  // round the plate
  ASSERT_EQ(moveVertex({0, 0.001, 0}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, 1, 0));
}

}  // namespace
}  // namespace fissure::vertex_sides_test
