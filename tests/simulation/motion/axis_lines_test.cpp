// Logs of one line an axis, as Falcon drivers dump them.
#include <gtest/gtest.h>

#include "temporary_log.h"

namespace fissure::axis_lines_test {

namespace {

ReplayMotion axes(double rate_hz) {
  ReplayMotion settings = rated(rate_hz);
  settings.layout = LogLayout::axes;
  return settings;
}

void expectThreeSamples(const std::string& text) {
  const auto motion = play(text, axes(10));
  EXPECT_EQ(count(*motion, "replay_samples"), 3);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 0);
  EXPECT_NEAR(motion->duration_s(), 0.2, 1e-15);
  EXPECT_LT((motion->poseAt(0.1).position_m - Vec3(2, -2, 20)).norm(), 1e-12);
  EXPECT_LT((motion->poseAt(9).position_m - Vec3(3, -3, 30)).norm(), 1e-14);
}

TEST(AxisLines, MayBeDividedAndEndAsTheyLike) {
  expectThreeSamples("1,2,3\n-1,-2,-3\n10,20,30\n");
  expectThreeSamples("1,2,3,\n-1,-2,-3,\n10,20,30,\n");  // trailing delimiters
  expectThreeSamples("1 2 3\r\n-1 -2  -3\r\n 10 +20 3e1");
  expectThreeSamples("\xEF\xBB\xBF\n1;2;3;;\n\n-1;-2;-3\n10;20;30\n\n");
}

TEST(AxisLines, OfUnequalLengthEndInSamplesWithoutAPose) {
  const auto motion = play("1,2,3,4\n-1,-2,-3\n10,20,30,40,50\n", axes(10));
  EXPECT_EQ(count(*motion, "replay_samples"), 3);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 2);
  EXPECT_NEAR(motion->duration_s(), 0.2, 1e-15);
  const auto hole = play("1,,3\n-1,-2,-3\n10,20,30\n", axes(10));
  EXPECT_EQ(count(*hole, "replay_samples"), 2);
  EXPECT_EQ(count(*hole, "replay_dropped_rows"), 1);
}

TEST(AxisLines, WhatIsNoneIsNamed) {
  EXPECT_EQ(playError("1,2\n3,4\n", axes(10)),
            "log.csv: has 2 lines of numbers, expected three: all x, all y and all z");
  EXPECT_EQ(playError("1\n2\n3\n\n4\n", axes(10)),
            "log.csv:5: a fourth line, expected three: all x, all y and all z");
  EXPECT_EQ(playError("1,2\n3,oops\n5,6\n", axes(10)),
            "log.csv:2: \"oops\" in sample 1 of y, expected a number like -0.0125 or nothing");
  EXPECT_EQ(playError("x,y,z\n1,2,3\n", axes(10)),
            "log.csv:1: \"x\" in sample 0 of x, expected a number like -0.0125 or nothing");
  EXPECT_NE(playError("", axes(10)).find("has 0 lines"), std::string::npos);
  EXPECT_NE(playError(",\n,\n,\n", axes(10)), "no InputError");
  ReplayMotion without_rate;
  without_rate.layout = LogLayout::axes;
  EXPECT_NE(playError("1\n2\n3\n", without_rate), "no InputError");
}

TEST(DeviceFrames, OfTheFalconAreItsDriversAxes) {
  // A hand at device (1, 2, 3): by CHAI3D one to the operator, two right, three up.
  ReplayMotion settings = axes(10);
  settings.mapping.frame = DeviceFrame::chai3d;
  EXPECT_EQ(play("1\n2\n3\n", settings)->poseAt(0).position_m, Vec3(2, 3, 1));
  settings.mapping.frame = DeviceFrame::novint;
  EXPECT_EQ(play("1\n2\n3\n", settings)->poseAt(0).position_m, Vec3(1, 2, 3));
  settings.mapping.origin_device_m = Vec3(0, 0, 0.125);  // what the driver adds
  EXPECT_EQ(play("1\n2\n3\n", settings)->poseAt(0).position_m, Vec3(1, 2, 3 - 0.125));
}

}  // namespace
}  // namespace fissure::axis_lines_test
