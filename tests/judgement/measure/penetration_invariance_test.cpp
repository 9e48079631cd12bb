// What must not change a measurement, and tissue in which depth could hide.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "slow_penetration.h"
#include "surface/oracles.h"

namespace fissure::penetration_invariance_test {

namespace {

const Vec3 kBlade(0.04, 0.002, 0.015);
constexpr double kSpacing_m = 0.002;

/// All of a state, moved as a whole.
State moved(const State& state, const Pose& world) {
  State result = state;
  for (Vec3& vertex : result.positions_m) vertex = world.toScene(vertex);
  for (ToolState& tool : result.tools)
    tool.pose = {world.toScene(tool.pose.position_m), world.orientation * tool.pose.orientation};
  return result;
}

/// Two bodies, one crumpled, and two tools that go through them at random.
struct Way {
  explicit Way(unsigned seed) : random(seed) {
    scene = test::makeScene({makeSphere(0.03, 2), test::moved(makeSphere(0.03, 2), test::at(0.05, 0, 0))},
                            {kBlade, {0.003, 0.05, 0.003}});
  }
  State next() {
    State state = test::restState(scene, {test::randomPose(random, 0.06), test::randomPose(random, 0.06)});
    const TriangleMesh folded = test::crumpledSphere(0.03, 2, 0.4, static_cast<unsigned>(random()));
    std::copy(folded.vertices_m.begin(), folded.vertices_m.end(), state.positions_m.begin());
    return state;
  }
  std::mt19937 random;
  Scene scene;
};

// Depth, stand-off, passing and inverted tissue, also where the common motion is another one in every step.
TEST(PenetrationInvariance, ACommonRigidMotionChangesNothing) {
  int deep = 0, gaps = 0, passed = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Way way(seed);
    PenetrationMeter here(way.scene, {kSpacing_m}), there(way.scene, {kSpacing_m});
    const Pose world = test::randomPose(way.random, 0.5);
    for (int step = 0; step < 12; ++step) {
      const State state = way.next();
      const Penetration a = here.measure(state), b = there.measure(moved(state, world));
      ASSERT_NEAR(a.depth_m, b.depth_m, 1e-12);
      ASSERT_EQ(std::isnan(a.stand_off_m), std::isnan(b.stand_off_m));
      if (!std::isnan(a.stand_off_m)) {
        ASSERT_NEAR(a.stand_off_m, b.stand_off_m, 1e-12);
      }
      ASSERT_EQ(a.inverted_triangles, b.inverted_triangles);
      ASSERT_EQ(a.passed_through, b.passed_through);
      deep += a.depth_m > 0.001;
      gaps += !std::isnan(a.stand_off_m);
      passed += a.passed_through > 0;
    }
  }
  EXPECT_GT(deep, 10);
  EXPECT_GT(gaps, 0);
  EXPECT_GT(passed, 15);
}

/// A state and its scene in a mirror at x = 0; tissue stays outward, and a box is its own mirror image.
void mirror(Scene& scene, State& state) {
  for (SceneBody& body : scene.bodies) {
    for (Vec3& vertex : body.rest.vertices_m) vertex.x() = -vertex.x();
    for (Face& face : body.rest.faces) std::swap(face[1], face[2]);
  }
  for (Vec3& vertex : state.positions_m) vertex.x() = -vertex.x();
  for (ToolState& tool : state.tools) {
    const Quat q = tool.pose.orientation;
    tool.pose.position_m.x() = -tool.pose.position_m.x();
    tool.pose.orientation = Quat(q.w(), q.x(), -q.y(), -q.z());
  }
}

// The samples of a box are not their own mirror image, so what they measure agrees up to their coverage only.
TEST(PenetrationInvariance, AMirrorChangesNothingButTheSamples) {
  int deep = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    Way way(seed);
    State state = way.next();
    double coverage_m = 0;
    for (const SceneTool& tool : way.scene.tools)
      coverage_m = std::max(coverage_m, makeToolSamples(way.scene, tool, kSpacing_m).coverage_m);
    const Penetration plain = PenetrationMeter(way.scene, {kSpacing_m}).measure(state);
    mirror(way.scene, state);
    const Penetration mirrored = PenetrationMeter(way.scene, {kSpacing_m}).measure(state);
    EXPECT_NEAR(plain.depth_m, mirrored.depth_m, coverage_m);
    EXPECT_EQ(plain.inverted_triangles, mirrored.inverted_triangles);
    deep += plain.depth_m > 0.003;
  }
  EXPECT_GE(deep, 8);
}

// Where a tissue vertex is the deepest of all, there is no sample in the number: the mirror gives it exactly.
TEST(PenetrationInvariance, AMirrorKeepsTheDepthOfVertices) {
  std::mt19937 random(71);
  int deep = 0;
  for (int i = 0; i < 40; ++i) {
    const Quat turn = Quat(Eigen::AngleAxisd(0.02 * i, Vec3(1, 0.3, -0.2).normalized()));
    const Scene plate = test::makeScene({makeSphere(0.03, 4)}, {{0.08, 0.005, 0.08}});
    Scene scene = plate;
    State state =
        test::restState(scene, {Pose{test::randomIn(random, 0.0004) + turn * Vec3(0, 0.0322, 0), turn}});
    const double plain_m = PenetrationMeter(scene, {0.04}).measure(state).depth_m;
    mirror(scene, state);
    EXPECT_NEAR(PenetrationMeter(scene, {0.04}).measure(state).depth_m, plain_m, 1e-12);
    deep += plain_m > 1e-4;
  }
  EXPECT_GT(deep, 20);
}

// Two lobes of one body overlap, the tool is where both are: twice inside is inside, as deep as the nearest
// of all sheets is away, and the buried sheets are reported.
TEST(HiddenDepth, TissueWoundTwiceCountsAsInsideAndIsReported) {
  const TriangleMesh lobes =
      test::together(makeSphere(0.03, 3), test::moved(makeSphere(0.03, 3), test::at(0.02, 0.003, 0.001)));
  const Vec3 size_m(0.01, 0.002, 0.006);
  const Scene scene = test::makeScene({lobes}, {size_m});
  const ToolSamples samples = makeToolSamples(scene, scene.tools[0], kSpacing_m);
  std::mt19937 random(72);
  for (int i = 0; i < 20; ++i) {
    Pose pose = test::randomPose(random, 0.003);
    pose.position_m.x() += 0.01;
    test::SlowPenetration slow{.gap_m = std::numeric_limits<double>::infinity()};
    test::measureSlowly(lobes, size_m, pose, samples.points_m, slow);
    ASSERT_EQ(slow.odd_samples, static_cast<int>(samples.points_m.size()));
    const Penetration found = PenetrationMeter(scene, {kSpacing_m}).measure(test::restState(scene, {pose}));
    EXPECT_NEAR(found.depth_m, slow.depth_m, 1e-13);
    EXPECT_GT(found.depth_m, 0.01);
    EXPECT_GT(found.inverted_triangles, 100);
  }
}

// One vertex of a sphere pulled right through and out of the far side, a small tool in that spike, which is
// tissue turned inside out (winding -1): no depth there, so the spike must be reported, however short, though
// no triangle's centroid has come out.
TEST(HiddenDepth, AToolInASpikeThroughTheFarSideIsReported) {
  const Vec3 size_m(0.0002, 0.0001, 0.0002);
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {size_m});
  for (const double length_m : {0.001, 0.005, 0.02, 0.07}) {
    State state = test::restState(scene, {test::at(0, -0.03 - length_m / 2, 0)});
    const auto top = std::max_element(state.positions_m.begin(), state.positions_m.end(),
                                      [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
    top->y() = -0.03 - length_m;
    const TriangleMesh spiked{state.positions_m, scene.bodies[0].rest.faces};
    ASSERT_NEAR(test::girardWinding(spiked, state.tools[0].pose.position_m), -1, 1e-9);
    const Penetration found = PenetrationMeter(scene, {}).measure(state);
    EXPECT_EQ(found.depth_m, 0);
    EXPECT_GE(found.inverted_triangles, 4) << length_m;
  }
}

// Not a number in a body far from every tool, or in the second tool: no depth at all rather than that of the
// rest; and the next good state is measured as if nothing had been.
TEST(HiddenDepth, NotANumberAnywhereHidesNothingBehindAFiniteDepth) {
  const Scene scene = test::makeScene(
      {makeSphere(0.03, 2), test::moved(makeSphere(0.03, 2), test::at(1, 0, 0))}, {kBlade, kBlade});
  const State good = test::restState(scene, {test::at(0, 0.02, 0), test::at(0, 0.5, 0)});
  PenetrationMeter meter(scene, {kSpacing_m});
  const double depth_m = meter.measure(good).depth_m;
  ASSERT_GT(depth_m, 0.005);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      State vertex = good, tool = good, turned = good;
      vertex.positions_m.back()[static_cast<Eigen::Index>(axis)] = bad;
      tool.tools[1].pose.position_m[static_cast<Eigen::Index>(axis)] = bad;
      turned.tools[1].pose.orientation.coeffs()[static_cast<Eigen::Index>(axis)] = bad;
      for (const State& state : {vertex, tool, turned}) {
        EXPECT_TRUE(std::isnan(meter.measure(state).depth_m));
        EXPECT_EQ(meter.measure(good).depth_m, depth_m);
      }
    }
  }
}

}  // namespace
}  // namespace fissure::penetration_invariance_test
