#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "temporary_log.h"

namespace fissure::scripted_motion_test {

namespace {

std::unique_ptr<Motion> script(const ScriptMotion& settings) {
  ToolSettings tool;
  tool.name = "blade";
  tool.motion = settings;
  return makeMotion(tool, ".");
}

MotionSegment move(const Vec3& to_m, double duration_s, Timing timing = Timing::constant) {
  MotionSegment segment;
  segment.move_to_m = to_m;
  segment.duration_s = duration_s;
  segment.timing = timing;
  return segment;
}

MotionSegment hold(double hold_s) {
  MotionSegment segment;
  segment.hold_s = hold_s;
  return segment;
}

Quat turn(const Vec3& axis, double angle_rad) {
  return Quat(Eigen::AngleAxisd(angle_rad, axis));
}

/// x of the way from 0 to 1 m in 1 s.
double wayAt(Timing timing, double ramp_fraction, double time_s) {
  ScriptMotion settings;
  settings.segments = {move({1, 0, 0}, 1, timing)};
  settings.segments[0].ramp_fraction = ramp_fraction;
  return script(settings)->poseAt(time_s).position_m.x();
}

std::string scriptError(const MotionSegment& segment) {
  ScriptMotion settings;
  settings.segments = {hold(1), segment};
  return inputError([&] { script(settings); });
}

TEST(Script, WithoutSegmentsStaysAtItsStart) {
  ScriptMotion settings;
  settings.start_m = {1, 2, 3};
  settings.start_orientation = turn(Vec3::UnitX(), 0.5);
  const auto motion = script(settings);
  EXPECT_EQ(motion->duration_s(), 0);
  for (const double time_s : {-1.0, 0.0, 10.0}) {
    EXPECT_EQ(motion->poseAt(time_s).position_m, Vec3(1, 2, 3));
    EXPECT_LT(motion->poseAt(time_s).orientation.angularDistance(settings.start_orientation), 1e-15);
  }
  EXPECT_TRUE(motion->summary().empty());
}

TEST(Script, ConstantTimingIsLinear) {
  for (const double u : {0.1, 0.25, 0.5, 0.9}) EXPECT_DOUBLE_EQ(wayAt(Timing::constant, 0.25, u), u);
}

TEST(Script, MinimumJerkFollowsFlashAndHogan) {
  for (const double u : {0.1, 0.25, 0.5, 0.9})
    EXPECT_NEAR(wayAt(Timing::minimum_jerk, 0.25, u),
                10 * std::pow(u, 3) - 15 * std::pow(u, 4) + 6 * std::pow(u, 5), 1e-14);
  EXPECT_DOUBLE_EQ(wayAt(Timing::minimum_jerk, 0.25, 0.25), 53.0 / 512);  // by hand
}

TEST(Script, TrapezoidalIsTheIntegralOfATrapezium) {
  for (const double ramp : {0.1, 0.25, 0.5}) {
    // The velocity: up to 1 / (1 - ramp) over the first ramp, down over the last; summed by the midpoint
    // rule.
    const double peak = 1 / (1 - ramp);
    const int steps = 10000;
    double way = 0;
    for (int i = 0; i < steps; ++i) {
      const double u = (i + 0.5) / steps;
      way += peak * std::min({1.0, u / ramp, (1 - u) / ramp}) / steps;
      if (i % 500 == 499) {
        EXPECT_NEAR(wayAt(Timing::trapezoidal, ramp, (i + 1.0) / steps), way, 1e-8);
      }
    }
  }
  EXPECT_DOUBLE_EQ(wayAt(Timing::trapezoidal, 0.25, 0.25), 1.0 / 6);  // 0.25 / 2 x 4 / 3
}

TEST(Script, SpeedIsTheMeanAlongTheWayInEveryTiming) {
  // 3-4-5: a way of 0.05 m at 0.1 m/s takes 0.5 s.
  for (const Timing timing : {Timing::constant, Timing::trapezoidal, Timing::minimum_jerk}) {
    ScriptMotion settings;
    MotionSegment segment;
    segment.move_to_m = Vec3(0.03, -0.04, 0);
    segment.speed_m_s = 0.1;
    segment.timing = timing;
    settings.segments = {segment};
    const auto motion = script(settings);
    EXPECT_DOUBLE_EQ(motion->duration_s(), 0.5);
    EXPECT_LT((motion->poseAt(0.25).position_m - Vec3(0.015, -0.02, 0)).norm(), 1e-15);  // all are symmetric
    EXPECT_EQ(motion->poseAt(0.5).position_m, Vec3(0.03, -0.04, 0));
  }
}

TEST(Script, HoldsAndMovesFollowEachOther) {
  // The paper's scene: 31 mm down at 0.1 m/s, then a hold, then back.
  ScriptMotion settings;
  settings.start_m = {0, 0.067, 0};
  settings.segments = {move({0, 0.036, 0}, 0.31), hold(0.25), move({0, 0.067, 0}, 0.1)};
  const auto motion = script(settings);
  EXPECT_DOUBLE_EQ(motion->duration_s(), 0.66);
  EXPECT_EQ(motion->poseAt(-1).position_m, settings.start_m);
  EXPECT_NEAR(motion->poseAt(0.155).position_m.y(), 0.0515, 1e-15);
  EXPECT_EQ(motion->poseAt(0.31).position_m.y(), 0.036);
  EXPECT_EQ(motion->poseAt(0.45).position_m.y(), 0.036);
  EXPECT_NEAR(motion->poseAt(0.61).position_m.y(), 0.0515, 1e-15);
  EXPECT_EQ(motion->poseAt(0.66).position_m.y(), 0.067);
  EXPECT_EQ(motion->poseAt(100).position_m.y(), 0.067);
}

TEST(Script, TurnsWhileItMovesOnTheShorterArc) {
  // To 270 degrees about z, written as such: the shorter arc is 90 degrees the other way.
  ScriptMotion settings;
  settings.segments = {move({0, 0, 1}, 2)};
  settings.segments[0].rotate_to = turn(Vec3::UnitZ(), 1.5 * std::numbers::pi);
  const Pose half_way = script(settings)->poseAt(1);
  EXPECT_LT((half_way.position_m - Vec3(0, 0, 0.5)).norm(), 1e-15);
  EXPECT_LT(half_way.orientation.angularDistance(turn(Vec3::UnitZ(), -0.25 * std::numbers::pi)), 1e-7);
}

TEST(Script, TurnsOnTheSpotWithTheTimingOfItsSegment) {
  ScriptMotion settings;
  MotionSegment segment;
  segment.rotate_to = turn(Vec3::UnitY(), 1.0);
  segment.duration_s = 1;
  segment.timing = Timing::minimum_jerk;
  settings.segments = {segment};
  const Quat at_quarter = script(settings)->poseAt(0.25).orientation;
  EXPECT_LT(at_quarter.angularDistance(turn(Vec3::UnitY(), 53.0 / 512)), 1e-7);
}

TEST(Script, PosesAreContinuousAndQuaternionsUnitAndOfOneSign) {
  ScriptMotion settings;
  settings.segments = {move({0.1, 0, 0}, 0.3, Timing::trapezoidal), hold(0.1),
                       move({0.1, 0.1, 0}, 0.3, Timing::minimum_jerk), move({0, 0, 0}, 0.3)};
  settings.segments[0].rotate_to = turn(Vec3::UnitZ(), 3);
  settings.segments[2].rotate_to = turn(Vec3::UnitX(), -2);
  settings.segments[3].rotate_to = Quat(-turn(Vec3::UnitY(), 2).coeffs());
  const auto motion = script(settings);
  const double step_s = 1e-4;
  for (double time_s = -0.01; time_s < 1.02; time_s += step_s) {
    const Pose before = motion->poseAt(time_s), after = motion->poseAt(time_s + step_s);
    EXPECT_LT((after.position_m - before.position_m).norm(), 1.0 * step_s);  // at most 0.1 x 1.875 / 0.3 m/s
    EXPECT_LT((after.orientation.coeffs() - before.orientation.coeffs()).norm(), 20 * step_s);
    EXPECT_NEAR(after.orientation.norm(), 1, 1e-14);
  }
}

TEST(Script, NormalisesRoundedQuaternions) {
  ScriptMotion settings;
  settings.start_orientation = Quat(0.7071, 0.7071, 0, 0);
  EXPECT_NEAR(script(settings)->poseAt(0).orientation.norm(), 1, 1e-15);
}

TEST(Script, AWayOfNoLengthMayTakeADuration) {
  ScriptMotion settings;
  settings.segments = {move({0, 0, 0}, 1), move({1, 0, 0}, 1)};
  EXPECT_EQ(script(settings)->duration_s(), 2);
  EXPECT_EQ(script(settings)->poseAt(0.5).position_m.x(), 0);
  EXPECT_EQ(script(settings)->poseAt(1.5).position_m.x(), 0.5);
}

TEST(Script, RefusesSegmentsThatSayTooLittleOrTooMuch) {
  const std::string here = "tools.blade.motion.segments.1";
  MotionSegment rotation;
  rotation.rotate_to = turn(Vec3::UnitX(), 1);
  rotation.speed_m_s = 0.1;
  EXPECT_EQ(scriptError(rotation), here + ": a way of no length, expected duration_s");

  EXPECT_EQ(scriptError({}), here + ": nothing to do, expected move_to_m, rotate_to or hold_s");

  MotionSegment untimed = move({1, 0, 0}, 1);
  untimed.duration_s.reset();
  EXPECT_EQ(scriptError(untimed), here + ": no timing, expected speed_m_s or duration_s");
  untimed.speed_m_s = 0.0;
  EXPECT_EQ(scriptError(untimed), here + ".speed_m_s: expected a value above 0");

  MotionSegment both = move({1, 0, 0}, 1);
  both.speed_m_s = 1;
  EXPECT_EQ(scriptError(both), here + ": both speed_m_s and duration_s, expected one of them");

  MotionSegment moving_hold = hold(1);
  moving_hold.move_to_m = Vec3::Zero();
  EXPECT_EQ(scriptError(moving_hold), here + ": hold_s stands beside a movement, expected it alone");
  EXPECT_EQ(scriptError(hold(-1)), here + ".hold_s: expected a value above 0");
  EXPECT_EQ(scriptError(move({1, 0, 0}, std::numeric_limits<double>::quiet_NaN())),
            here + ".duration_s: expected a value above 0");

  MotionSegment steep = move({1, 0, 0}, 1, Timing::trapezoidal);
  steep.ramp_fraction = 0.6;
  EXPECT_EQ(scriptError(steep), here + ".ramp_fraction: expected a value above 0, at most 0.5");

  MotionSegment nowhere = move({1, 0, 0}, 1);
  nowhere.rotate_to = Quat(0, 0, 0, 0);
  EXPECT_EQ(scriptError(nowhere), here + ".rotate_to: no rotation, expected a unit quaternion x, y, z, w");
}

}  // namespace
}  // namespace fissure::scripted_motion_test
