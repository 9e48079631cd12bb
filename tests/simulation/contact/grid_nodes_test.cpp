#include "contact/grid_nodes.h"

#include <gtest/gtest.h>

namespace fissure::grid_nodes_test {

namespace {

TEST(GridNodes, PutsMutualPairsOnBothLargeFacesOfASpatula) {
  const Vec3 size(0.04, 0.002, 0.015);
  const ToolNodes nodes = makeGridNodes(size, {8, 4});
  ASSERT_EQ(nodes.size(), 2 * 8 * 4);
  for (int i = 0; i < nodes.size(); ++i) {
    const int partner = nodes.partners[i];
    EXPECT_EQ(nodes.partners[partner], i);
    EXPECT_NE(partner, i);
    EXPECT_DOUBLE_EQ(nodes.thicknesses_m[i], 0.002);
    EXPECT_EQ(nodes.normals[i], Vec3(-nodes.normals[partner]));
    EXPECT_DOUBLE_EQ(std::abs(nodes.positions_m[i].y()), 0.001);
    EXPECT_GT(nodes.normals[i].y() * nodes.positions_m[i].y(), 0) << "out of the tool";
    const Vec3 across = nodes.positions_m[i] - nodes.positions_m[partner];
    EXPECT_EQ(across.x(), 0);
    EXPECT_EQ(across.z(), 0);
  }
}

TEST(GridNodes, PutsRowsOnTheNarrowFacesToo) {
  const Vec3 size(0.04, 0.002, 0.015);
  const ToolNodes nodes = makeGridNodes(size, {8, 4}, 3);
  const ToolNodes large = makeGridNodes(size, {8, 4});
  EXPECT_TRUE(nodes.all_sides);
  EXPECT_FALSE(large.all_sides);
  ASSERT_EQ(nodes.size(), 2 * 8 * 4 + 2 * 3 * (8 + 4));
  for (int i = 0; i < large.size(); ++i) EXPECT_EQ(nodes.positions_m[i], large.positions_m[i]);
  std::array<int, 3> count{};
  for (int i = 0; i < nodes.size(); ++i) {
    const int partner = nodes.partners[i];
    int axis = 0;
    nodes.normals[i].cwiseAbs().maxCoeff(&axis);
    ++count[axis];
    EXPECT_EQ(nodes.partners[partner], i);
    EXPECT_EQ(nodes.normals[i], Vec3(-nodes.normals[partner]));
    EXPECT_DOUBLE_EQ(nodes.positions_m[i].dot(nodes.normals[i]), size[axis] / 2);
    EXPECT_DOUBLE_EQ(nodes.thicknesses_m[i], size[axis]);
    const Vec3 across = nodes.positions_m[i] - nodes.positions_m[partner];
    EXPECT_DOUBLE_EQ(across.norm(), size[axis]) << "straight across the tool";
  }
  EXPECT_EQ(count, (std::array<int, 3>{2 * 3 * 4, 2 * 8 * 4, 2 * 3 * 8}));
}

TEST(GridNodes, ReachTheBorderOfTheFace) {
  const ToolNodes nodes = makeGridNodes({0.04, 0.002, 0.015}, {8, 8});
  Vec3 low = Vec3::Constant(1), high = Vec3::Constant(-1);
  for (const Vec3& p : nodes.positions_m) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  EXPECT_TRUE(high.isApprox(Vec3(0.02, 0.001, 0.0075), 1e-15));
  EXPECT_TRUE(low.isApprox(Vec3(-0.02, -0.001, -0.0075), 1e-15));
}

TEST(GridNodes, ResolutionCountsAlongTheLongerEdgeFirst) {
  // Longest edge z, thin edge x: 5 nodes along z, 3 along y.
  const ToolNodes nodes = makeGridNodes({0.001, 0.02, 0.06}, {5, 3});
  ASSERT_EQ(nodes.size(), 30);
  EXPECT_DOUBLE_EQ(nodes.positions_m[3].z() - nodes.positions_m[0].z(), 0.06 / 4);
  EXPECT_DOUBLE_EQ(nodes.positions_m[1].y() - nodes.positions_m[0].y(), 0.02 / 2);
}

TEST(GridNodes, ASingleNodeStandsInTheMiddle) {
  const ToolNodes nodes = makeGridNodes({0.04, 0.002, 0.015}, {1, 1});
  ASSERT_EQ(nodes.size(), 2);
  EXPECT_EQ(nodes.positions_m[0], Vec3(0, 0.001, 0));
  EXPECT_EQ(nodes.positions_m[1], Vec3(0, -0.001, 0));
}

}  // namespace
}  // namespace fissure::grid_nodes_test
