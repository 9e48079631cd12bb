#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "temporary_log.h"

namespace fissure::replayed_motion_test {

namespace {

double xAt(const Motion& motion, double time_s) {
  return motion.poseAt(time_s).position_m.x();
}

/// A log t,x,y,z of the given times and x; y and z are 0.
std::string logOf(const std::vector<std::pair<double, double>>& samples) {
  std::string text = "t,x,y,z\n";
  for (const auto& [t, x] : samples) text += std::to_string(t) + "," + std::to_string(x) + ",0,0\n";
  return text;
}

TEST(Replay, IsLinearBetweenSamples) {
  const auto motion = play(logOf({{7, 0}, {7.1, 0.01}, {7.2, 0.05}}), timed());
  EXPECT_NEAR(motion->duration_s(), 0.2, 1e-12);
  EXPECT_NEAR(xAt(*motion, 0.05), 0.005, 1e-12);
  EXPECT_NEAR(xAt(*motion, 0.175), 0.04, 1e-12);
  EXPECT_EQ(xAt(*motion, -1), 0);
  EXPECT_EQ(xAt(*motion, 1), 0.05);
}

TEST(Replay, RateCountsDroppedRowsInTime) {
  // 10 Hz; rows 0, 3 and the last two, of columns of unequal length, have no pose.
  const auto motion = play("x,y,z\n,0,0\n1,0,0\n2,0,0\n3,,0\n4,0,0\n,,\n5,0\n", rated(10));
  EXPECT_EQ(count(*motion, "replay_samples"), 3);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 4);
  EXPECT_EQ(xAt(*motion, 0), 1);  // held until the first sample at 0.1 s
  EXPECT_EQ(xAt(*motion, 0.1), 1);
  EXPECT_EQ(xAt(*motion, 0.2), 2);
  EXPECT_NEAR(xAt(*motion, 0.3), 3, 1e-12);  // half way over the dropped row: 0.2 s is no gap
  EXPECT_NEAR(xAt(*motion, 0.4), 4, 1e-12);
  EXPECT_DOUBLE_EQ(motion->duration_s(), 0.4);
}

TEST(Replay, DropsRowsWithoutAPose) {
  ReplayMotion settings = timed();
  settings.quaternion_columns = {"a", "b", "c", "d"};
  const auto motion = play(
      "t,x,y,z,a,b,c,d\n"
      "0,nan,0,0,0,0,0,1\n"    // not a number
      "1,1,0,0,0,0,0,1\n"      // the first kept: time zero
      "1.05,1,0,0,0,0,0,0\n"   // a zero quaternion
      "1.1,2,0,inf,0,0,0,1\n"  // infinite
      ",2,0,0,0,0,0,1\n"       // no time
      "1.15,2,0,0,0,0,0\n"     // a row too short
      "1.2,2,0,0,0,0,0,2\n",   // kept: normalised
      settings);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 5);
  EXPECT_EQ(count(*motion, "replay_samples"), 2);
  EXPECT_NEAR(xAt(*motion, 0.1), 1.5, 1e-12);
  EXPECT_NEAR(motion->poseAt(0.2).orientation.norm(), 1, 1e-15);
}

TEST(Replay, RepeatedTimesDropTheLaterRow) {
  const auto motion = play("t,x,y,z\n0,0,0,0\n0.1,1,0,0\n0.1,9,0,0\n0.2,,,\n0.2,2,0,0\n", timed());
  EXPECT_EQ(count(*motion, "replay_repeated_rows"), 1);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 1);  // its time is then free for the row that has a pose
  EXPECT_EQ(count(*motion, "replay_samples"), 3);
  EXPECT_EQ(xAt(*motion, 0.1), 1);
  EXPECT_EQ(xAt(*motion, 0.2), 2);
}

TEST(Replay, TimeGoingBackIsAnErrorWithItsLine) {
  EXPECT_EQ(playError("t,x,y,z\n0,0,0,0\n0.2,1,0,0\n0.1,2,0,0\n", timed()),
            "log.csv:4: time goes back from 0.2 to 0.1 s in column \"t\", expected rows in order of time");
  // Also after a row without a pose.
  EXPECT_EQ(playError("t,x,y,z\n0,0,0,0\n0.2,,0,0\n0.1,2,0,0\n", timed()),
            "log.csv:4: time goes back from 0.2 to 0.1 s in column \"t\", expected rows in order of time");
}

TEST(Replay, HoldsThroughGapsAndJumpsAtTheirEnd) {
  for (const auto interpolation : {Interpolation::linear, Interpolation::monotone_cubic}) {
    ReplayMotion settings = timed();
    settings.interpolation = interpolation;
    settings.max_gap_s = 0.25;
    settings.jump_m = 10;
    // Exactly 0.25 s is no gap yet.
    const auto motion = play(logOf({{0, 0}, {0.25, 1}, {0.51, 2}, {0.6, 3}}), settings);
    EXPECT_EQ(count(*motion, "replay_gaps"), 1);
    EXPECT_NEAR(xAt(*motion, 0.125), 0.5, 1e-12);
    EXPECT_EQ(xAt(*motion, 0.25), 1);
    EXPECT_EQ(xAt(*motion, 0.4), 1);
    EXPECT_EQ(xAt(*motion, 0.5099999), 1);
    EXPECT_EQ(xAt(*motion, 0.51), 2);
    EXPECT_NEAR(xAt(*motion, 0.555), 2.5, 1e-12);  // both runs have two samples, so they are straight
  }
}

TEST(Replay, GapEndsAreMetByStepsThatMissThemByRounding) {
  // The step 3 x 0.1 s is 0.30000000000000004; 0.1 + 0.7 is 0.7999999999999999 and stands for 0.8.
  const auto motion = play(logOf({{0, 0}, {0.1, 1}, {0.8, 2}}), timed());
  EXPECT_EQ(xAt(*motion, 0.1 + 0.7), 2);
}

TEST(Replay, CountsJumpsAndFrozenSamples) {
  // In millimetres; 40 mm in one sample, then frozen for three samples, then 20 mm, which is not more than
  // the limit.
  ReplayMotion settings = rated(100);
  settings.position_unit = LengthUnit::mm;
  const auto motion = play("x,y,z\n0,0,0\n1,0,0\n41,0,0\n41,0,0\n41,0,0\n41,0,0\n61,0,0\n60,1,0\n", settings);
  EXPECT_EQ(count(*motion, "replay_samples"), 8);
  EXPECT_EQ(count(*motion, "replay_jumps"), 1);
  EXPECT_EQ(count(*motion, "replay_held_samples"), 3);
  EXPECT_EQ(count(*motion, "replay_gaps"), 0);
  EXPECT_NEAR(xAt(*motion, 0.015), 0.021, 1e-12);  // the jump is played as it is
  EXPECT_NEAR(xAt(*motion, 0.04), 0.041, 1e-15);
}

TEST(Replay, ATurnOnTheSpotIsNotFrozen) {
  ReplayMotion settings = rated(100);
  settings.quaternion_columns = {"a", "b", "c", "d"};
  const auto motion = play("x,y,z,a,b,c,d\n0,0,0,0,0,0,1\n0,0,0,0.1,0,0,1\n0,0,0,0.1,0,0,1\n", settings);
  EXPECT_EQ(count(*motion, "replay_held_samples"), 1);
}

TEST(Replay, MapsTheDeviceToTheScene) {
  // CHAI3D's frame (x to the operator, y right, z up) to a scene with x right, y up, z to the operator.
  ReplayMotion settings = rated(10);
  settings.position_unit = LengthUnit::mm;
  settings.quaternion_columns = {"qx", "qy", "qz", "qw"};
  settings.mapping.axes = {"y", "z", "x"};
  settings.mapping.scale = 0.5;
  settings.mapping.origin_device_m = {0.125, 0, 0};
  settings.mapping.origin_scene_m = {0, 0.06, 0};
  settings.mapping.mount = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
  // A quarter turn about the device's z, the scene's y.
  const auto motion =
      play("x,y,z,qx,qy,qz,qw\n125,0,0,0,0,0,1\n145,10,-30,0,0,0.70710678118654752,0.70710678118654752\n",
           settings);
  EXPECT_LT((motion->poseAt(0).position_m - Vec3(0, 0.06, 0)).norm(), 1e-15);
  EXPECT_LT((motion->poseAt(0.1).position_m - Vec3(0.005, 0.06 - 0.015, 0.01)).norm(), 1e-15);
  const auto& mapped = motion->poseAt(0.1);
  // At rest in the device's frame: R then the mount. A point on the tool's y axis goes by the mount to device
  // z, and by the axes to scene y, which the quarter turn about it leaves; one on x goes to device y, scene x
  // ... by hand below.
  EXPECT_LT((mapped.rotateToScene(Vec3::UnitY()) - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_LT((mapped.rotateToScene(Vec3::UnitX()) - Vec3::UnitX()).norm(), 1e-15);
  EXPECT_LT((motion->poseAt(0).rotateToScene(Vec3::UnitX()) - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(Replay, NegatedAxesMapToo) {
  ReplayMotion settings = rated(10);
  settings.mapping.axes = {"-x", "z", "+y"};
  const auto motion = play("x,y,z\n1,2,3\n", settings);
  EXPECT_EQ(motion->duration_s(), 0);
  EXPECT_EQ(motion->poseAt(5).position_m, Vec3(-1, 3, 2));
}

TEST(Replay, WithoutQuaternionsTheMountAloneTurnsTheTool) {
  ReplayMotion settings = rated(10);
  settings.mapping.axes = {"y", "z", "x"};
  settings.mapping.mount = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  EXPECT_LT(play("x,y,z\n1,2,3\n1,2,4\n", settings)
                ->poseAt(0.05)
                .orientation.angularDistance(settings.mapping.mount),
            1e-7);
}

TEST(Replay, MirroredOrUnknownAxesAndOtherBadSettingsAreErrors) {
  const std::string text = "x,y,z\n1,2,3\n1,2,3\n";
  const auto error = [&](const std::array<std::string, 3>& axes) {
    ReplayMotion settings = rated(10);
    settings.mapping.axes = axes;
    return playError(text, settings);
  };
  EXPECT_NE(error({"x", "z", "y"}).find("mapping.axes: x, z, y is no right-handed frame"), std::string::npos);
  EXPECT_NE(error({"x", "x", "y"}).find("is no right-handed frame"), std::string::npos);
  EXPECT_NE(error({"x", "y", "w"}).find("mapping.axes: \"w\""), std::string::npos);
  EXPECT_NE(error({"x", "y", ""}).find("mapping.axes: \"\""), std::string::npos);

  ReplayMotion settings = rated(10);
  settings.time_column = "t";
  EXPECT_EQ(playError(text, settings),
            "tools.hand.motion: both time_column and rate_hz, expected one of them");
  EXPECT_EQ(playError(text, {}), "tools.hand.motion: neither time_column nor rate_hz, expected one of them");
  EXPECT_EQ(playError(text, rated(0)), "tools.hand.motion.rate_hz: expected a value above 0");
  settings = rated(10);
  settings.start_s = 0.2;
  EXPECT_EQ(playError(text, settings),
            "log.csv: ends at 0.1 s of log time, but tools.hand.motion.start_s is 0.2");
  settings.start_s = 0;
  settings.end_s = 0.4;  // the log ends at 0.1 s, and 0.25 s more may be held
  EXPECT_EQ(playError(text, settings),
            "log.csv: ends at 0.1 s of log time, but tools.hand.motion.end_s is 0.4");
  settings.end_s = 0.0;
  EXPECT_EQ(playError(text, settings), "tools.hand.motion.end_s: expected a value above start_s");
  settings.end_s = 0.3;
  EXPECT_EQ(play(text, settings)->duration_s(), 0.3);
}

TEST(Replay, StartAndEndCutTheLogAndItsCounts) {
  // 10 Hz, x = row. Rows 2 and 8 have no pose; the device is frozen at row 4 and jumps at row 7.
  const std::string text =
      "x,y,z\n0,0,0\n0.01,0,0\n,0,0\n0.03,0,0\n0.03,0,0\n0.05,0,0\n0.06,0,0\n0.17,0,0\n,0,0\n0.19,0,0\n";
  const auto whole = play(text, rated(10));
  EXPECT_EQ(count(*whole, "replay_samples"), 8);
  EXPECT_EQ(count(*whole, "replay_dropped_rows"), 2);
  EXPECT_EQ(count(*whole, "replay_held_samples"), 1);
  EXPECT_EQ(count(*whole, "replay_jumps"), 1);

  ReplayMotion settings = rated(10);
  settings.start_s = 0.15;
  settings.end_s = 0.45;
  const auto part = play(text, settings);
  EXPECT_NEAR(part->duration_s(), 0.3, 1e-15);
  EXPECT_NEAR(xAt(*part, 0), 0.015, 1e-12);   // between rows 1 and 3
  EXPECT_NEAR(xAt(*part, 0.3), 0.04, 1e-12);  // between rows 4 and 5
  EXPECT_NEAR(xAt(*part, 5), 0.04, 1e-12);
  EXPECT_EQ(count(*part, "replay_samples"), 2);  // rows 3 and 4
  EXPECT_EQ(count(*part, "replay_dropped_rows"), 1);
  EXPECT_EQ(count(*part, "replay_held_samples"), 1);
  EXPECT_EQ(count(*part, "replay_jumps"), 0);
}

TEST(Replay, QuaternionsTurnOnTheShorterArcWhateverTheirSign) {
  // Turns of 0.2 rad a sample about z, every other one written with the opposite sign.
  std::string text = "x,y,z,qx,qy,qz,qw\n";
  for (int i = 0; i < 20; ++i) {
    const double sign = i % 2 ? -1 : 1;
    text += "0,0,0,0,0," + std::to_string(sign * std::sin(0.1 * i)) + "," +
            std::to_string(sign * std::cos(0.1 * i)) + "\n";
  }
  ReplayMotion settings = rated(10);
  settings.quaternion_columns = {"qx", "qy", "qz", "qw"};
  const auto motion = play(text, settings);
  for (double time_s = 0; time_s < 1.9; time_s += 0.01) {
    const Quat wanted(Eigen::AngleAxisd(2 * time_s, Vec3::UnitZ()));
    const Quat got = motion->poseAt(time_s).orientation;
    EXPECT_LT((got.coeffs() - wanted.coeffs()).norm(), 2e-6);  // with its sign: continuous
  }
}

TEST(Replay, BothInterpolationsMeetEverySampleAndCubicNeverOvershoots) {
  // A random walk with plateaus, reversals and irregular steps of 14 to 120 ms.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step_s(0.014, 0.12), step_m(-0.01, 0.01);
  std::vector<double> times = {100};
  std::vector<Vec3> points = {Vec3::Zero()};
  while (times.size() < 300) {
    times.push_back(times.back() + step_s(random));
    Vec3 next = points.back();
    for (int axis = 0; axis < 3; ++axis)
      if (random() % 3) next[axis] += step_m(random);
    points.push_back(next);
  }
  std::string text = "t x y z\n";
  for (std::size_t i = 0; i < times.size(); ++i) {
    char line[200];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g %.17g\n", times[i], points[i].x(), points[i].y(),
                  points[i].z());
    text += line;
  }
  for (const auto interpolation : {Interpolation::linear, Interpolation::monotone_cubic}) {
    ReplayMotion settings = timed();
    settings.interpolation = interpolation;
    const auto motion = play(text, settings);
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_LT((motion->poseAt(times[i] - times[0]).position_m - points[i]).norm(), 1e-9);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      Vec3 previous = points[i];
      for (int k = 1; k <= 16; ++k) {
        const double share = k / 16.0;
        const Vec3 point = motion->poseAt(times[i] + share * (times[i + 1] - times[i]) - times[0]).position_m;
        for (int axis = 0; axis < 3; ++axis) {
          const double way = points[i + 1][axis] - points[i][axis];
          // Monotone between two samples, and so never outside them.
          EXPECT_GE((point[axis] - previous[axis]) * (way < 0 ? -1 : 1), -1e-12);
          if (way == 0) {
            EXPECT_NEAR(point[axis], points[i][axis], 1e-12);
          }
        }
        previous = point;
      }
    }
  }
}

TEST(Replay, CubicIsMoreAccurateThanLinearOnASmoothMotion) {
  // x = t^2 for t = 0 ... 2 s in steps of 0.1 s: rising, so no slope is cut, and three-point differences are
  // exact.
  std::vector<std::pair<double, double>> samples;
  for (int i = 0; i <= 20; ++i) samples.emplace_back(0.1 * i, 0.01 * i * i);
  ReplayMotion settings = timed();
  settings.interpolation = Interpolation::monotone_cubic;
  const auto cubic = play(logOf(samples), settings);
  settings.interpolation = Interpolation::linear;
  const auto linear = play(logOf(samples), settings);
  for (double t = 0.1; t < 1.9; t += 0.01) EXPECT_NEAR(xAt(*cubic, t), t * t, 1e-12);
  EXPECT_NEAR(xAt(*linear, 1.05), 1.05 * 1.05 + 0.0025, 1e-12);
}

TEST(Replay, CubicVelocityIsContinuousAtSamples) {
  ReplayMotion settings = timed();
  settings.interpolation = Interpolation::monotone_cubic;
  const auto motion = play(logOf({{0, 0}, {0.1, 0.01}, {0.15, 0.03}, {0.25, 0.04}, {0.3, 0.02}}), settings);
  const double h = 1e-6;
  for (const double t : {0.1, 0.15, 0.25}) {
    const double before = (xAt(*motion, t) - xAt(*motion, t - h)) / h;
    const double after = (xAt(*motion, t + h) - xAt(*motion, t)) / h;
    EXPECT_NEAR(before, after, 1e-4);
  }
}

}  // namespace
}  // namespace fissure::replayed_motion_test
