#include "measure/penetration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::penetration_test {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const Vec3 kBlade(0.04, 0.002, 0.015);

Penetration measureOnce(const Scene& scene, const State& state,
                        std::optional<double> spacing_m = std::nullopt) {
  return PenetrationMeter(scene, {spacing_m}).measure(state);
}

/// Lowest height over the blade's corners, relative to its origin.
double lowestCorner_m(const Quat& orientation, const Vec3& size) {
  return -(orientation.toRotationMatrix().row(1).transpose().cwiseAbs().dot(size)) / 2;
}

// A tissue box 0.2 m on edge, its top at y = 0; far from its sides depth is just how far below the top a
// point is.
Scene bigBoxScene(const Vec3& tool = kBlade) {
  return test::makeScene({test::moved(makeBox({0.2, 0.2, 0.2}), test::at(0, -0.1, 0))}, {tool});
}

TEST(Penetration, IsZeroApartAndNaNStandOffFarAway) {
  const Penetration far = measureOnce(bigBoxScene(), test::restState(bigBoxScene(), {test::at(0, 0.05, 0)}));
  EXPECT_EQ(far.depth_m, 0);
  EXPECT_EQ(far.passed_through, 0);
  EXPECT_EQ(far.inverted_triangles, 0);
  EXPECT_TRUE(std::isnan(far.stand_off_m));
}

TEST(Penetration, StandOffIsTheGapWhileNothingPenetrates) {
  const Scene scene = bigBoxScene();
  for (const double gap : {1e-6, 0.0005, 0.009}) {
    const Penetration p = measureOnce(scene, test::restState(scene, {test::at(0.01, 0.001 + gap, 0.02)}));
    EXPECT_EQ(p.depth_m, 0);
    EXPECT_NEAR(p.stand_off_m, gap, 1e-12);
  }
  EXPECT_TRUE(std::isnan(measureOnce(scene, test::restState(scene, {test::at(0, 0.0111, 0)})).stand_off_m));
  EXPECT_TRUE(std::isnan(measureOnce(scene, test::restState(scene, {test::at(0, 0.0005, 0)})).stand_off_m));
}

// The sphere's top vertex points at the middle of a blade 0.3 mm above: no sample is exactly there, the
// vertex is.
TEST(Penetration, StandOffSeesTissueVerticesBetweenSamples) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
  const Penetration p = measureOnce(scene, test::restState(scene, {test::at(0.0001, 0.0313, 0.0002)}), 0.01);
  EXPECT_NEAR(p.stand_off_m, 0.0003, 1e-12);
}

// Accuracy: a blade pressed corner first, so that its lowest corner is 3 mm below the top. Closed form 3 mm;
// the error is one-sided and at most the distance from that corner to its nearest sample, which the table
// bounds.
TEST(PenetrationAccuracy, OfATiltedBladeInABigBox) {
  struct Row {
    double spacing_m;
    double worst_error_m;
  };
  const double depth_m = 0.003;
  std::mt19937 random(51);
  for (const Row& row :
       {Row{0.004, 0.4e-3}, Row{0.002, 0.22e-3}, Row{0.001, 0.11e-3}, Row{0.0005, 0.055e-3}}) {
    const Scene scene = bigBoxScene();
    double worst_m = 0;
    for (int i = 0; i < 25; ++i) {
      const Quat orientation = test::randomRotation(random);
      const Pose pose{Vec3(0.01, -depth_m - lowestCorner_m(orientation, kBlade), 0.005), orientation};
      const double measured_m = measureOnce(scene, test::restState(scene, {pose}), row.spacing_m).depth_m;
      EXPECT_LE(measured_m, depth_m + 1e-12);
      worst_m = std::max(worst_m, depth_m - measured_m);
    }
    EXPECT_LE(worst_m, row.worst_error_m) << row.spacing_m;
    EXPECT_GE(worst_m, 0.1 * row.worst_error_m) << row.spacing_m;  // the table is not slack
  }
}

// A blade pressed flat, `depth` below the top of a sphere of 8,192 triangles: points of its lower face are
// the deepest, or the top vertex, which is inside it. Closed form for the sphere: depth at most. Two errors,
// both downwards: a triangle's sagitta, 1.9 mm on edge at most, 1.9^2 / (8 x 30) = 0.015 mm; and the deepest
// sample lies up to the coverage radius r (and the blade's own offset of 0.22 mm) beside the axis, which
// costs at most r^2 / R.
TEST(PenetrationAccuracy, OfABladePressedIntoAFineSphere) {
  const Scene scene = test::makeScene({makeSphere(0.03, 5)}, {kBlade});
  for (const double spacing_m : {0.002, 0.001, 0.0005}) {
    const double coverage_m = makeToolSamples(scene, scene.tools[0], spacing_m).coverage_m;
    for (const double depth_m : {0.0004, 0.0017, 0.004, 0.01}) {
      const State state = test::restState(scene, {test::at(0.0002, 0.03 - depth_m + 0.001, 0.0001)});
      const double measured_m = measureOnce(scene, state, spacing_m).depth_m;
      EXPECT_LE(measured_m, depth_m + 1e-12);
      EXPECT_GE(measured_m, depth_m - 0.000015 - coverage_m * coverage_m / 0.03)
          << spacing_m << " " << depth_m;
    }
  }
}

// Case (b): a plate 80 x 5 x 80 mm; its lower face is `depth` below the sphere's top vertex. Samples 20 mm
// apart miss the cap (10 mm wide), the vertex does not; the top vertex is nearest to the lower face up to
// half the thickness.
TEST(Penetration, OfATissueVertexInsideAPlateIsExact) {
  const Scene scene = test::makeScene({makeSphere(0.03, 4)}, {{0.08, 0.005, 0.08}});
  for (const double depth_m : {1e-5, 0.0004}) {
    const Penetration p =
        measureOnce(scene, test::restState(scene, {test::at(0.003, 0.03 - depth_m + 0.0025, 0.001)}), 0.04);
    EXPECT_NEAR(p.depth_m, depth_m, 1e-14);
    EXPECT_TRUE(std::isnan(p.stand_off_m));
  }
}

TEST(Penetration, OfAToolAsTrianglesEqualsTheBox) {
  Scene scene = bigBoxScene();
  scene.bodies[0].rest = makeSphere(0.03, 4);
  std::mt19937 random(52);
  for (int i = 0; i < 10; ++i) {
    Pose pose = test::randomPose(random, 0.003);
    pose.position_m.y() += 0.03;
    const State state = test::restState(scene, {pose});
    const double box_m = measureOnce(scene, state, 0.0004).depth_m;
    Scene triangles = scene;
    triangles.tools[0].box_size_m.reset();
    EXPECT_NEAR(measureOnce(triangles, state, 0.0004).depth_m, box_m, 0.0004);
    EXPECT_GT(box_m, 0.001);
  }
}

// Blade fully inside a tissue box 0.2 m on edge, in its middle: the sample nearest to the centre plane is 0.1
// m deep.
TEST(Penetration, OfAToolFullyInside) {
  const Penetration p = measureOnce(bigBoxScene(), test::restState(bigBoxScene(), {test::at(0, -0.1, 0)}));
  EXPECT_NEAR(p.depth_m, 0.1, 0.001);  // the large faces are 1 mm from the middle
  EXPECT_LE(p.depth_m, 0.1);
}

// A rod 100 mm long through the middle of a sphere of radius 30 mm, both ends outside: depth is near the
// inradius.
TEST(Penetration, OfARodThroughASphere) {
  const Scene scene = test::makeScene({makeSphere(0.03, 4)}, {{0.002, 0.1, 0.002}});
  const State state = test::restState(scene, {Pose{}});
  const Penetration p = measureOnce(scene, state);
  EXPECT_GT(p.depth_m, 0.03 - 0.002 - 0.0008);
  EXPECT_LT(p.depth_m, 0.03 - 0.0009);
}

// Against the definition, sample by sample, with brute force: also where tissue is folded and
// self-intersecting.
TEST(Penetration, EqualsTheDefinitionByBruteForce) {
  std::mt19937 random(53);
  for (unsigned seed = 0; seed < 12; ++seed) {
    const TriangleMesh folded = test::crumpledSphere(0.03, 2, seed % 3 == 0 ? 0.0 : 0.4, seed);
    Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
    State state = test::restState(scene, {test::randomPose(random, 0.03)});
    state.positions_m = folded.vertices_m;
    const ToolSamples samples = makeToolSamples(scene, scene.tools[0], 0.003);
    double expected_m = 0;
    for (const Vec3& sample : samples.points_m) {
      const Vec3 point = state.tools[0].pose.toScene(sample);
      if (test::solidAngleWinding(folded, point) > 0.5) {
        expected_m = std::max(expected_m, test::bruteDistance(folded, point));
      }
    }
    for (const Vec3& vertex : folded.vertices_m) {
      const Vec3 in_tool = state.tools[0].pose.toBody(vertex);
      expected_m = std::max(expected_m, (kBlade / 2 - in_tool.cwiseAbs()).minCoeff());
    }
    EXPECT_NEAR(measureOnce(scene, state, 0.003).depth_m, expected_m, 1e-14) << seed;
  }
}

TEST(Penetration, TakesTheWorseOfTwoBodiesAndOfTwoTools) {
  const TriangleMesh left = test::moved(makeBox({0.1, 0.1, 0.1}), test::at(-0.06, -0.05, 0));
  const TriangleMesh right = test::moved(makeBox({0.1, 0.1, 0.1}), test::at(0.06, -0.05, 0));
  const Scene scene = test::makeScene({left, right}, {kBlade, kBlade});
  const auto depth = [&](double first, double second) {
    return measureOnce(scene, test::restState(scene, {test::at(-0.06, 0.001 - first, 0),
                                                      test::at(0.06, 0.001 - second, 0)}))
        .depth_m;
  };
  EXPECT_NEAR(depth(0.004, 0.001), 0.004, 1e-12);
  EXPECT_NEAR(depth(0.001, 0.004), 0.004, 1e-12);
  EXPECT_NEAR(depth(-0.5, 0.003), 0.003, 1e-12);
  EXPECT_EQ(depth(-0.5, -0.5), 0);
}

// Depth is measured to the surface of the body that holds the sample, not to that of an overlapping
// neighbour.
TEST(Penetration, InOverlappingBodiesIsMeasuredBodyByBody) {
  const Scene scene = test::makeScene(
      {makeBox({0.1, 0.1, 0.1}), test::moved(makeBox({0.1, 0.1, 0.1}), test::at(0, 0.012, 0))},
      {{0.01, 0.002, 0.01}});
  // The tool's lower face is 0.02 below the first top and 0.032 below the second; sides are farther.
  const Penetration p = measureOnce(scene, test::restState(scene, {test::at(0, 0.05 - 0.02 + 0.001, 0)}));
  EXPECT_NEAR(p.depth_m, 0.032, 1e-12);
}

TEST(Penetration, DoesNotChangeWhenEverythingMovesTogether) {
  std::mt19937 random(54);
  const Scene scene = test::makeScene({makeSphere(0.03, 3)}, {kBlade});
  const TriangleMesh folded = test::crumpledSphere(0.03, 3, 0.3, 9);
  for (int i = 0; i < 10; ++i) {
    const Pose tool = test::randomPose(random, 0.02), world = test::randomPose(random, 0.5);
    State one = test::restState(scene, {tool}), other = one;
    one.positions_m = folded.vertices_m;
    other.positions_m = test::moved(folded, world).vertices_m;
    other.tools[0].pose = {world.toScene(tool.position_m), world.orientation * tool.orientation};
    const Penetration a = measureOnce(scene, one), b = measureOnce(scene, other);
    EXPECT_NEAR(a.depth_m, b.depth_m, 1e-14);
    EXPECT_EQ(a.inverted_triangles, b.inverted_triangles);
    EXPECT_GT(a.inverted_triangles, 0);
  }
}

// The blade lies inside a mirrored sphere: its winding number is -1, so no depth, but every triangle is
// reported.
TEST(Penetration, IsZeroInTissueTurnedInsideOutWhichIsCounted) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
  State state = test::restState(scene, {test::at(0.0, 0.015, 0.0)});
  EXPECT_GT(measureOnce(scene, state).depth_m, 0.01);
  for (Vec3& vertex : state.positions_m) vertex.x() = -vertex.x();
  const Penetration p = measureOnce(scene, state);
  EXPECT_EQ(p.depth_m, 0);
  EXPECT_EQ(p.inverted_triangles, 128);
}

TEST(Penetration, IsNaNForAnyPositionThatIsNotUsable) {
  const Scene scene = test::makeScene({makeSphere(0.03, 3)}, {kBlade});
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity(), 1e30, -1e300}) {
    State tissue = test::restState(scene, {test::at(0, 0.02, 0)});
    tissue.positions_m[17].z() = bad;
    State tool = test::restState(scene, {test::at(0, bad, 0)});
    for (const State& state : {tissue, tool}) {
      const Penetration p = measureOnce(scene, state);
      EXPECT_TRUE(std::isnan(p.depth_m));
      EXPECT_TRUE(std::isnan(p.stand_off_m));
      EXPECT_EQ(p.inverted_triangles, 512);
    }
  }
  State turned = test::restState(scene, {test::at(0, 0.02, 0)});
  turned.tools[0].pose.orientation.w() = kNaN;
  EXPECT_TRUE(std::isnan(measureOnce(scene, turned).depth_m));
}

TEST(Penetration, GoesOnAfterAStateThatCouldNotBeMeasured) {
  const Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
  PenetrationMeter meter(scene, {});
  meter.measure(test::restState(scene, {test::at(0, 0.05, 0)}));
  meter.measure(test::restState(scene, {test::at(0, kNaN, 0)}));
  const Penetration p = meter.measure(test::restState(scene, {test::at(0, -0.05, 0)}));
  EXPECT_EQ(p.depth_m, 0);
  EXPECT_EQ(p.passed_through, 0);  // the way there is not known
}

// One vertex far out, still within the limit: wild shapes cost time, never correctness or an end.
TEST(Penetration, SurvivesHugeButUsableCoordinates) {
  const Scene scene = test::makeScene({makeSphere(0.03, 3)}, {kBlade});
  PenetrationMeter meter(scene, {});
  for (const double far : {1.0, 1e3, 1e6}) {
    State state = test::restState(scene, {test::at(0, 0.025, 0)});
    state.positions_m[100] = Vec3(far, -far, far);
    EXPECT_TRUE(std::isfinite(meter.measure(state).depth_m));
  }
}

TEST(Penetration, DoesNotDependOnToolNodes) {
  Scene scene = test::makeScene({makeSphere(0.03, 2)}, {kBlade});
  const State state = test::restState(scene, {test::at(0.001, 0.028, 0.002)});
  const double without_m = measureOnce(scene, state).depth_m;
  scene.tools[0].nodes.positions_m.assign(64, Vec3(0, 0.001, 0));
  EXPECT_EQ(measureOnce(scene, state).depth_m, without_m);
}

}  // namespace
}  // namespace fissure::penetration_test
