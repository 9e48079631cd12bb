#include "contact/rim_edges.h"

#include <gtest/gtest.h>

namespace fissure::rim_edges_test {

namespace {

constexpr double kMargin_m = 0.001;
constexpr double kLimit_m = 0.005;

/// One tissue edge (the third vertex of its triangle is far away) and a plate of 80 x 5 x 80 mm around the
/// origin; its rim is at z = 40 mm.
class RimEdgesTest : public testing::Test {
 protected:
  RimEdgesTest() {
    scene.bodies.push_back(
        {.name = "tissue",
         .rest = {.vertices_m = {{1, 1, 1}, {1, 1, 2}, {0.01, -1, 0}}, .faces = {{0, 1, 2}, {1, 0, 2}}}});
    scene.tools.push_back({.name = "plate", .surface = {}, .box_size_m = Vec3(0.08, 0.005, 0.08)});
    edges.emplace(scene, std::vector<double>{kMargin_m}, kLimit_m);
  }
  const std::vector<ContactConstraint>& find(const Vec3& a, const Vec3& b, const Vec3& way) {
    std::vector<Vec3> now = {a, b, {0.01, -1, 0}};
    const std::vector<Vec3> before = {a - way, b - way, {0.01, -1, 0}};
    found.clear();
    const std::vector<ToolState> resting(1);
    edges->find({.positions_m = now, .before_m = before, .tools_before = resting, .tools_now = resting}, {},
                found);
    return found;
  }
  Scene scene;
  std::optional<RimEdges> edges;
  std::vector<ContactConstraint> found;
};

// Both ends are outside the plate, the edge cuts through its rim 1 mm above the middle.
TEST_F(RimEdgesTest, ACreaseOverTheRimIsHeldInFrontOfTheFaceItCameFrom) {
  ASSERT_EQ(find({0.01, -0.005, 0.034}, {0.01, 0.003, 0.042}, {0, 0.01, 0}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, -1, 0)) << "though the upper face is nearer";
  EXPECT_EQ(found[0].vertices[0], 0);
  EXPECT_EQ(found[0].vertices[1], 1);
  EXPECT_NEAR(found[0].weights[0], 0.25, 1e-12);
  EXPECT_NEAR(found[0].weights[1], 0.75, 1e-12);
  EXPECT_EQ(found[0].weights[2], 0);
  EXPECT_EQ(found[0].position_m, Vec3(0, -0.0025, 0));
  EXPECT_EQ(found[0].target_m, kMargin_m);
}

TEST_F(RimEdgesTest, ACreaseThatWasInsideBeforeIsOnTheNearerSide) {
  ASSERT_EQ(find({0.01, -0.004, 0.034}, {0.01, 0.004, 0.042}, {0, 0, 0}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, 1, 0)) << "2 mm above the middle, 0.5 mm below the face";
}

// A plate 20 mm thick, put into the tissue so that the edge crosses its rim 2 mm above its middle.
TEST_F(RimEdgesTest, AnEdgeDeepInsideFromTheStartIsFree) {
  scene.tools[0].box_size_m = Vec3(0.1, 0.02, 0.1);
  edges.emplace(scene, std::vector<double>{kMargin_m}, kLimit_m);
  const Vec3 a(0.01, -0.004, 0.044), b(0.01, 0.004, 0.052);
  EXPECT_TRUE(find(a, b, {0, 0, 0}).empty());
  ASSERT_EQ(find(a, b, {0, -0.012, 0}).size(), 1u) << "it came in from above in this step";
  EXPECT_EQ(found[0].normal, Vec3(0, 1, 0));
  EXPECT_EQ(found[0].target_m, kMargin_m);
}

// The same plate: what one step did not bring is undone only as far as the limit.
TEST_F(RimEdgesTest, APushBeyondTheApproachIsLimited) {
  edges.emplace(scene, std::vector<double>{kMargin_m}, 0.0003);
  ASSERT_EQ(find({0.01, -0.005, 0.034}, {0.01, 0.005, 0.042}, {0, 0, 0}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, 1, 0)) << "2.5 mm above the middle: at the face";
  EXPECT_NEAR(found[0].target_m, 0.0003, 1e-9) << "the margin of 1 mm in several steps";
}

TEST_F(RimEdgesTest, AnEdgeThatComesFromTheSideIsHeldAtTheSide) {
  ASSERT_EQ(find({0.01, -0.001, 0.039}, {0.01, 0.001, 0.042}, {0, 0, -0.01}).size(), 1u);
  EXPECT_EQ(found[0].normal, Vec3(0, 0, 1));
}

TEST_F(RimEdgesTest, EdgesBesideBelowOrWithinTheRimAreFree) {
  EXPECT_TRUE(find({0.05, -0.005, 0.034}, {0.05, 0.003, 0.042}, {0, 0.01, 0}).empty()) << "beside";
  EXPECT_TRUE(find({0.01, -0.009, 0.034}, {0.01, -0.0036, 0.042}, {0, 0.001, 0}).empty()) << "below";
  EXPECT_TRUE(find({0.01, -0.005, 0.03}, {0.01, 0.003, 0.038}, {0, 0.01, 0}).empty()) << "within";
}

}  // namespace
}  // namespace fissure::rim_edges_test
