#include "measure/passage.h"

#include <gtest/gtest.h>

#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"
#include "surface/winding.h"

namespace fissure::passage_test {

namespace {

// Whatever surface and point do in a step, entering minus leaving is the change of the winding number.
TEST(Crossings, AccountForEveryChangeOfWinding) {
  std::mt19937 random(31);
  std::vector<Crossing> crossings;
  int crossed = 0, several = 0;
  for (unsigned step = 0; step < 40; ++step) {
    SurfaceTree tree(test::crumpledSphere(1.0, 2, 0.4, step));
    const SurfaceTree before = tree;
    tree.update(
        test::moved(test::crumpledSphere(1.0, 2, 0.4, step + 1), test::randomPose(random, 0.5)).vertices_m);
    for (int i = 0; i < 300; ++i) {
      const Vec3 from = test::randomIn(random, 1.5), to = i % 3 == 0 ? from : test::randomIn(random, 1.5);
      findCrossings(tree, from, to, crossings);
      int sum = 0;
      double last = 0;
      for (const Crossing& crossing : crossings) {
        sum += crossing.entering ? 1 : -1;
        EXPECT_GE(crossing.time, last);
        last = crossing.time;
        EXPECT_EQ(crossing.direction.dot(crossing.normal) < 0, crossing.entering);
      }
      crossed += !crossings.empty();
      several += crossings.size() > 2;
      ASSERT_EQ(sum, windingNumber(tree, to) - windingNumber(before, from));
    }
  }
  EXPECT_GT(crossed, 3'000);
  EXPECT_GT(several, 100);
}

/// A blade 30 x 2 x 15 mm and a sphere of radius 30 mm at the origin; every point of the blade is within 16.9
/// mm of its middle axis, so that a blade passing through the centre meets faces of opposite sides.
class PassageThroughSphere : public ::testing::Test {
 protected:
  /// Moves the blade on a straight way in `steps` steps and returns the last measurement.
  Penetration move(const Vec3& from, const Vec3& to, int steps) {
    for (int i = 0; i <= steps; ++i) {
      const Vec3 position = from + (static_cast<double>(i) / steps) * (to - from);
      last_ = meter_.measure(test::restState(scene_, {Pose{position, Quat::Identity()}}));
      deepest_m_ = std::max(deepest_m_, last_.depth_m);
    }
    return last_;
  }

  Scene scene_ = test::makeScene({makeSphere(0.03, 2)}, {{0.03, 0.002, 0.015}});
  PenetrationMeter meter_{scene_, MeasureSettings{}};
  Penetration last_;
  double deepest_m_ = 0;
};

TEST_F(PassageThroughSphere, SlowlyEverySampleHasPassed) {
  EXPECT_EQ(move({0.0003, 0.05, 0.0002}, {0.0003, -0.05, 0.0002}, 150).passed_through, meter_.sampleCount());
  EXPECT_EQ(last_.depth_m, 0);
  EXPECT_GT(deepest_m_, 0.025);
}

TEST_F(PassageThroughSphere, InOneStepEverySampleHasPassed) {
  EXPECT_EQ(move({0.0003, 0.05, 0.0002}, {0.0003, -0.05, 0.0002}, 1).passed_through, meter_.sampleCount());
  EXPECT_EQ(deepest_m_, 0);  // no step shows any penetration: this is what passed_through is for
}

TEST_F(PassageThroughSphere, ExactlyThroughVerticesAndEdgesToo) {
  EXPECT_EQ(move({0, 0.05, 0}, {0, -0.05, 0}, 7).passed_through, meter_.sampleCount());
}

TEST_F(PassageThroughSphere, StaysCountedOnWayBackAndCountsOnce) {
  move({0, 0.05, 0}, {0, -0.05, 0}, 3);
  EXPECT_EQ(move({0, -0.05, 0}, {0, 0.06, 0}, 5).passed_through, meter_.sampleCount());
  EXPECT_EQ(move({0, 0.06, 0}, {0.2, 0.06, 0}, 2).passed_through, meter_.sampleCount());
}

TEST_F(PassageThroughSphere, InAndOutIsNotPassing) {
  move({0, 0.05, 0}, {0, 0.005, 0}, 30);
  EXPECT_EQ(move({0, 0.005, 0}, {0, 0.06, 0}, 30).passed_through, 0);
  EXPECT_EQ(move({0, 0.06, 0}, {0, 0.0, 0}, 1).passed_through, 0);  // in by a jump
  EXPECT_EQ(move({0, 0.0, 0}, {0, 0.06, 0}, 1).passed_through, 0);  // and out
  EXPECT_GT(deepest_m_, 0.02);
}

// The blade's lower face dips 3 mm below the top and crosses sideways: chords at 27 of 30 mm, both ends face
// up.
TEST_F(PassageThroughSphere, SidewaysGrazeIsNotPassing) {
  EXPECT_EQ(move({-0.06, 0.028, 0}, {0.06, 0.028, 0}, 80).passed_through, 0);
  EXPECT_GT(deepest_m_, 0.002);
  EXPECT_EQ(move({0.06, 0.028, 0}, {-0.06, 0.028, 0}, 1).passed_through, 0);
}

TEST_F(PassageThroughSphere, LeavingTissueItStartedInIsNotPassing) {
  EXPECT_EQ(move({0, 0, 0}, {0, -0.06, 0}, 20).passed_through, 0);
}

TEST_F(PassageThroughSphere, MovingTissueCountsLikeAMovingTool) {
  for (const int steps : {1, 60}) {
    PenetrationMeter meter(scene_, {});
    Penetration together, alone;
    for (int i = 0; i <= steps; ++i) {
      const Pose shift = test::at(0, -0.06 + 0.12 * i / steps, 0);
      State state = test::restState(scene_, {test::at(0, 0.04 + 0.12 * i / steps, 0)});
      for (Vec3& vertex : state.positions_m) vertex = shift.toScene(vertex);
      together = meter_.measure(state);  // side by side: no relative motion
      state.tools[0].pose = Pose{};
      alone = meter.measure(state);
    }
    EXPECT_EQ(together.passed_through, 0);
    EXPECT_EQ(alone.passed_through, meter.sampleCount());
    meter_ = PenetrationMeter(scene_, {});
  }
}

// A blade half beside the sphere: those samples pass whose vertical line meets the sphere at faces of
// opposite sides.
TEST_F(PassageThroughSphere, OnlyTheSamplesThatMeetTheBodyCount) {
  const Vec3 start(0.025, 0.05, 0.0);
  const SurfaceTree tree(scene_.bodies[0].rest);
  std::vector<Crossing> crossings;
  long long expected = 0;
  for (const Vec3& sample : makeToolSamples(scene_, scene_.tools[0], std::nullopt).points_m) {
    const Vec3 from = SurfaceTree::toTree(sample + start);
    findCrossings(tree, from, from - SurfaceTree::toTree({0, 0.1, 0}), crossings);
    ASSERT_TRUE(crossings.empty() || crossings.size() == 2);
    if (!crossings.empty()) expected += crossings[0].normal.dot(crossings[1].normal) < 0;
  }
  ASSERT_GT(expected, 500);
  ASSERT_LT(expected, meter_.sampleCount() - 500);
  EXPECT_EQ(move(start, start - Vec3(0, 0.1, 0), 90).passed_through, expected);
}

TEST(Passage, NeedsBothConditions) {
  const Vec3 up(0, 1, 0), down(0, -1, 0);
  const Crossing in{0.2, true, up, down};
  struct Case {
    Crossing out;
    bool passed;
  };
  for (const Case& c : {Case{{0.8, false, down, down}, true}, Case{{0.8, false, up, up}, false},
                        Case{{0.8, false, up, down}, false}, Case{{0.8, false, down, up}, false}}) {
    Passage passage(1);
    EXPECT_EQ(passage.advance(0, std::vector{in, c.out}, false), c.passed);
    EXPECT_FALSE(passage.advance(0, std::vector{in}, true));
    EXPECT_FALSE(passage.advance(0, {}, true));
    EXPECT_EQ(passage.advance(0, std::vector{c.out}, false), c.passed);
    EXPECT_FALSE(passage.advance(0, std::vector{c.out}, false));  // not entered again
  }
}

}  // namespace
}  // namespace fissure::passage_test
