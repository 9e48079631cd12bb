#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/jaw_poses.h"
#include "motion/timing.h"
#include "scenario/rigid_tools.h"
#include "temporary_log.h"

namespace fissure::clamp_motion_test {

namespace {

MotionSegment opening(double to_m, double duration_s, Timing timing) {
  MotionSegment segment;
  segment.open_to_m = to_m;
  segment.duration_s = duration_s;
  segment.timing = timing;
  return segment;
}

std::unique_ptr<Motion> script(const ScriptMotion& settings) {
  ToolSettings tool;
  tool.name = "clamp";
  tool.motion = settings;
  return makeMotion(tool, ".");
}

// Closes from 40 to 10 mm in 2 s, holds 1 s, opens to 20 mm on its way up, then stays.
TEST(ClampScript, OpensAlongTheTimingOfItsSegments) {
  for (const Timing timing : {Timing::constant, Timing::trapezoidal, Timing::minimum_jerk}) {
    ScriptMotion settings;
    settings.start_opening_m = 0.04;
    MotionSegment hold, away = opening(0.02, 0, timing);
    hold.hold_s = 1;
    away.duration_s.reset();
    away.move_to_m = Vec3(0, 0.5, 0);
    away.speed_m_s = 0.25;
    settings.segments = {opening(0.01, 2, timing), hold, away};
    const auto motion = script(settings);
    EXPECT_EQ(motion->duration_s(), 5);
    EXPECT_EQ(motion->openingAt(-1), 0.04);
    EXPECT_EQ(motion->openingAt(0), 0.04);
    for (const double u : {0.25, 0.5, 0.8}) {
      const double way = wayCovered(timing, 0.25, u);
      EXPECT_NEAR(motion->openingAt(2 * u), 0.04 - 0.03 * way, 1e-16);
      EXPECT_NEAR(motion->openingAt(3 + 2 * u), 0.01 + 0.01 * way, 1e-16);
      EXPECT_NEAR(motion->poseAt(3 + 2 * u).position_m.y(), 0.5 * way, 1e-15) << "both together";
    }
    for (const double time_s : {2.0, 2.5, 3.0}) EXPECT_EQ(motion->openingAt(time_s), 0.01);
    for (const double time_s : {5.0, 9.0}) EXPECT_EQ(motion->openingAt(time_s), 0.02);
  }
}

TEST(ClampScript, ClosedUnlessItSaysOtherwise) {
  EXPECT_EQ(script({})->openingAt(0), 0);
}

/// A log in which each axis tells its own story: 10 Hz.
const char* const log =
    "x,y,z\n"
    "0.00,0.00,0.10\n"
    "0.01,0.02,0.11\n"
    "0.02,0.04,0.13\n"
    "0.03,0.06,0.08\n";

ReplayMotion opened(DeviceAxis axis, double closed_m, double open_m) {
  ReplayMotion settings = rated(10);
  settings.opening = DeviceOpening{axis, closed_m, open_m, 0.04, std::nullopt};
  return settings;
}

TEST(ClampReplay, OneDeviceAxisOpensAndTheOthersMoveInAPlane) {
  ReplayMotion settings = opened(DeviceAxis::z, 0.09, 0.12);
  settings.mapping.origin_device_m = Vec3(0, 0, 0.1);
  settings.mapping.origin_scene_m = Vec3(1, 2, 3);
  settings.mapping.scale = 2;
  const auto motion = play(log, settings);
  for (int sample = 0; sample < 4; ++sample) {
    const Pose pose = motion->poseAt(0.1 * sample);
    EXPECT_NEAR(pose.position_m.x(), 1 + 2 * 0.01 * sample, 1e-15);
    EXPECT_NEAR(pose.position_m.y(), 2 + 2 * 0.02 * sample, 1e-15);
    EXPECT_EQ(pose.position_m.z(), 3) << "in its plane";
  }
  EXPECT_NEAR(motion->openingAt(0), 0.04 / 3, 1e-15);
  EXPECT_NEAR(motion->openingAt(0.05), 0.04 / 2, 1e-15) << "between two samples";
  EXPECT_NEAR(motion->openingAt(0.1), 0.04 * 2 / 3, 1e-15);
  EXPECT_EQ(motion->openingAt(0.2), 0.04) << "beyond its limit";
  EXPECT_EQ(motion->openingAt(0.3), 0);
  EXPECT_EQ(count(*motion, "replay_saturated_openings"), 2);
  EXPECT_EQ(count(*motion, "replay_samples"), 4);
}

// CHAI3D's x comes towards the operator, which is the scene's z; here pulling it to oneself closes.
TEST(ClampReplay, ReadsTheAxisInTheDevicesOwnFrame) {
  ReplayMotion settings = opened(DeviceAxis::x, 0.02, 0.01);
  settings.mapping.frame = DeviceFrame::chai3d;
  const auto motion = play(log, settings);
  EXPECT_EQ(motion->openingAt(0), 0.04);
  EXPECT_NEAR(motion->openingAt(0.15), 0.02, 1e-15);
  EXPECT_NEAR(motion->openingAt(0.2), 0, 1e-15);
  EXPECT_NEAR((motion->poseAt(0.2).position_m - Vec3(0.04, 0.13, 0)).norm(), 0, 1e-15);
  EXPECT_EQ(count(*motion, "replay_saturated_openings"), 2) << "the first and the last sample";
}

TEST(ClampReplay, ATurnedAxisOpensAlike) {
  ReplayMotion settings = opened(DeviceAxis::z, 0.09, 0.12);
  settings.mapping.axes = {"y", "-z", "-x"};
  EXPECT_NEAR(play(log, settings)->openingAt(0.1), 0.04 * 2 / 3, 1e-15);
}

TEST(ClampReplay, OthersHaveNoOpening) {
  const auto motion = play(log, rated(10));
  EXPECT_EQ(motion->openingAt(0.1), 0);
  EXPECT_EQ(count(*motion, "replay_saturated_openings"), -1);
}

TEST(JawPoses, ParallelJawsGoHalfTheOpeningEach) {
  ToolSettings tool;
  tool.clamp = ClampSettings{.jaw_position_m = {0.002, 0.01, 0.003}};
  const Pose pose{Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()))};
  const auto [left, right] = jawPoses(*tool.clamp, closedJaws(tool), pose, 0.05);
  // The clamp's x is the scene's y, its y the scene's -x.
  EXPECT_LT((right.position_m - Vec3(1 - 0.01, 2 + 0.027, 3.003)).norm(), 1e-15);
  EXPECT_LT((left.position_m - Vec3(1 - 0.01, 2 - 0.027, 3.003)).norm(), 1e-15);
  for (const Pose& jaw : {left, right}) EXPECT_LT(jaw.orientation.angularDistance(pose.orientation), 1e-15);
}

TEST(JawPoses, HingedJawsTurnAboutTheHinge) {
  ToolSettings tool;
  tool.clamp = ClampSettings{
      .opening = ClampOpening::hinged, .hinge_height_m = 0.1, .jaw_position_m = {0.002, 0, 0.003}};
  const auto closed = closedJaws(tool);
  const auto shut = jawPoses(*tool.clamp, closed, {}, 0);
  EXPECT_LT((shut[1].position_m - Vec3(0.002, 0, 0.003)).norm(), 1e-16);
  const auto [left, right] = jawPoses(*tool.clamp, closed, {}, 60);
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  EXPECT_LT((right.position_m - Vec3(0.002 * c + 0.1 * s, 0.1 - 0.1 * c + 0.002 * s, 0.003)).norm(), 1e-15);
  EXPECT_LT((left.position_m - Vec3(-right.position_m.x(), right.position_m.y(), 0.003)).norm(), 1e-15);
  EXPECT_NEAR(left.orientation.angularDistance(right.orientation), std::numbers::pi / 3, 1e-12);
}

}  // namespace
}  // namespace fissure::clamp_motion_test
