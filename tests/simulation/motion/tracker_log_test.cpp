// Logs as optical trackers write them: missing poses as huge numbers, a column that says whether the tool was
// seen, frame numbers for time.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "temporary_log.h"

namespace fissure::tracker_log_test {

namespace {

/// Millimetres and quaternions (w first) at 60 Hz. Frames 103 to 105: not seen; frame 107 is missing.
const std::string tracker_text =
    "Frame,State,Q0,Qx,Qy,Qz,Tx,Ty,Tz\n"
    "101,OK,1,0,0,0,10,-5,-1000\n"
    "102,OK,1,0,0,0,11,-5,-1000\n"
    "103,Missing,-3.697314E28,-3.697314E28,-3.697314E28,-3.697314E28,-3.697314E28,-3.697314E28,-3.697314E28\n"
    "104,Missing,,,,,,,\n"
    "105,OK,1,0,0,0,-3.697314E28,-3.697314E28,-3.697314E28\n"
    "106,OK,1,0,0,0,15,-5,-1000\n"
    "108,OK,1,0,0,0,17,-5,-1000\n";

ReplayMotion tracked() {
  ReplayMotion settings;
  settings.rate_hz = 60;
  settings.frame_column = "Frame";
  settings.position_columns = {"Tx", "Ty", "Tz"};
  settings.position_unit = LengthUnit::mm;
  settings.quaternion_columns = {"Qx", "Qy", "Qz", "Q0"};
  return settings;
}

double x_mm(const Motion& motion, double frames) {
  return 1000 * motion.poseAt(frames / 60).position_m.x();
}

TEST(TrackerLog, AMissingValueIsNoPose) {
  const auto motion = play(tracker_text, tracked());
  EXPECT_EQ(count(*motion, "replay_samples"), 4);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 3);
  EXPECT_EQ(count(*motion, "replay_rows_beyond_reason"), 2);
  EXPECT_EQ(count(*motion, "replay_filtered_rows"), -1) << "no filter";
  for (double frame = 0; frame <= 7; frame += 0.25) EXPECT_NEAR(x_mm(*motion, frame), 10 + frame, 1e-9);
  ASSERT_EQ(motion->notes().size(), 1u);
  EXPECT_NE(motion->notes()[0].find("log.csv:4: -3.697314e+28 in column \"Tx\" is no measurement (beyond "
                                    "1e+06): the first of 2 in the log, rows without a pose"),
            std::string::npos)
      << motion->notes()[0];
}

TEST(TrackerLog, FrameNumbersAreTime) {
  const auto motion = play(tracker_text, tracked());
  EXPECT_DOUBLE_EQ(motion->duration_s(), 7.0 / 60);
  ReplayMotion by_row = tracked();
  by_row.frame_column.reset();
  EXPECT_DOUBLE_EQ(play(tracker_text, by_row)->duration_s(), 6.0 / 60) << "the missing frame is not a row";
}

TEST(TrackerLog, FrameNumbersAreWholeAndInOrder) {
  EXPECT_EQ(playError("Frame,Tx,Ty,Tz,Qx,Qy,Qz,Q0\n1,0,0,0,0,0,0,1\n2.5,0,0,0,0,0,0,1\n", tracked()),
            "log.csv:3: frame 2.5 in column \"Frame\", expected whole numbers");
  EXPECT_EQ(playError("Frame,Tx,Ty,Tz,Qx,Qy,Qz,Q0\n3,0,0,0,0,0,0,1\n2,0,0,0,0,0,0,1\n", tracked()),
            "log.csv:3: frame goes back from 3 to 2 in column \"Frame\", expected rows in order of frames");
  ReplayMotion both = tracked();
  both.rate_hz.reset();
  both.time_column = "Frame";
  EXPECT_NE(playError(tracker_text, both).find("both time_column and frame_column"), std::string::npos);
}

TEST(TrackerLog, RowsAreFilteredByAColumn) {
  ReplayMotion settings = tracked();
  settings.where = RowFilter{"State", "OK"};
  const auto motion = play(tracker_text, settings);
  EXPECT_EQ(count(*motion, "replay_filtered_rows"), 2);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 1);
  EXPECT_EQ(count(*motion, "replay_samples"), 4);
  // What is left out is not looked at: neither words nor time.
  settings = timed();
  settings.where = RowFilter{"s", "1"};
  const auto words = play("t,x,y,z,s\n0,0,0,0,1\n9,lost,lost,lost,0\n0.1,0.01,0,0,\"1\"\n", settings);
  EXPECT_EQ(count(*words, "replay_samples"), 2);
  EXPECT_DOUBLE_EQ(words->duration_s(), 0.1);
  // By row and rate a row that is left out still takes its time.
  settings = rated(10);
  settings.where = RowFilter{"s", "1"};
  EXPECT_DOUBLE_EQ(play("x,y,z,s\n0,0,0,1\n1,0,0,0\n0.01,0,0,1\n", settings)->duration_s(), 0.2);
}

TEST(TrackerLog, AFilterThatLeavesNothingSaysWhatThereIs) {
  ReplayMotion settings = tracked();
  settings.where = RowFilter{"State", "ok"};
  EXPECT_EQ(
      playError(tracker_text, settings),
      "log.csv: none of its 7 rows has \"ok\" in column \"State\" (the first has \"OK\"), expected some");
  settings.where = RowFilter{"Status", "OK"};
  EXPECT_NE(playError(tracker_text, settings).find("did you mean"), std::string::npos);
}

// Trackers leave the time of what they do not see as they leave its pose.
TEST(TrackerLog, AStampBeyondReasonIsNoTime) {
  const std::string by_time = "t,x,y,z\n0,0,0,0\n-3.697314E28,0.01,0,0\n1e30,0.02,0,0\n0.1,0.03,0,0\n";
  const auto timed_motion = play(by_time, timed());
  EXPECT_EQ(count(*timed_motion, "replay_samples"), 2);
  EXPECT_EQ(count(*timed_motion, "replay_dropped_rows"), 2);
  EXPECT_EQ(count(*timed_motion, "replay_rows_beyond_reason"), 2);
  EXPECT_DOUBLE_EQ(timed_motion->duration_s(), 0.1);
  ASSERT_FALSE(timed_motion->notes().empty());
  EXPECT_NE(timed_motion->notes()[0].find(
                "log.csv:3: -3.697314e+28 in column \"t\" is no measurement (beyond 1e+19): the first of 2"),
            std::string::npos)
      << timed_motion->notes()[0];
  ReplayMotion frames = rated(10);
  frames.frame_column = "t";
  const auto by_frame = play("t,x,y,z\n-3.697314E28,9,9,9\n5,0,0,0\n1e30,0.01,0,0\n6,0.02,0,0\n", frames);
  EXPECT_EQ(count(*by_frame, "replay_samples"), 2);
  EXPECT_EQ(count(*by_frame, "replay_rows_beyond_reason"), 2);
  EXPECT_DOUBLE_EQ(by_frame->duration_s(), 0.1);
  ReplayMotion epoch = timed();
  epoch.time_unit = TimeUnit::ns;
  EXPECT_NEAR(play("t,x,y,z\n1800000000000000000,0,0,0\n1800000000100000000,0,0,0\n", epoch)->duration_s(),
              0.1, 1e-6)
      << "nanoseconds since 1970";
}

TEST(TrackerLog, WithoutAnyReasonableRowSaysSo) {
  EXPECT_EQ(playError("t,x,y,z\n0,1e30,0,0\n1,1e30,0,0\n", timed()).substr(0, 40),
            "log.csv: none of its 2 rows has a pose: ");
  EXPECT_TRUE(playError("t,x,y,z\n0,1e30,0,0\n1,1e30,0,0\n", timed())
                  .ends_with("log.csv:2: 1e+30 in column \"x\" is no measurement (beyond 1e+06)"));
}

TEST(TrackerLog, AQuaternionOfAnyReasonableLengthButZeroIsARotation) {
  ReplayMotion settings = timed();
  settings.quaternion_columns = {"a", "b", "c", "d"};
  const auto motion = play(
      "t,x,y,z,a,b,c,d\n0,0,0,0,0,0,0,1\n0.1,0,0,0,3e18,3e18,0,0\n0.2,0,0,0,0,0,1e-160,1e-160\n"
      "0.3,0,0,0,0,0,0,1073741824\n0.4,0,0,0,0,0,0,0\n0.5,0,0,0,nan,0,0,1\n"
      "0.6,0,0,0,-3.7e28,-3.7e28,-3.7e28,-3.7e28\n0.7,0,0,0,1e160,0,0,1e160\n",
      settings);
  EXPECT_EQ(count(*motion, "replay_samples"), 4);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 4) << "of zeros, missing, and two beyond reason";
  EXPECT_EQ(count(*motion, "replay_rows_beyond_reason"), 2);
  const double half = std::sqrt(0.5);
  EXPECT_TRUE(motion->poseAt(0.1).orientation.isApprox(Quat(0, half, half, 0)));
  EXPECT_TRUE(motion->poseAt(0.3).orientation.isApprox(Quat::Identity()));
  for (double time_s = 0; time_s <= 0.3; time_s += 0.05)
    EXPECT_NEAR(motion->poseAt(time_s).orientation.norm(), 1, 1e-12) << time_s;
}

TEST(TimeUnits, AreReadFromTheColumnsName) {
  const std::pair<const char*, double> names[] = {{"t", 1},
                                                  {"time_s", 1},
                                                  {"time_ms", 1e-3},
                                                  {"t_us", 1e-6},
                                                  {"stamp_ns", 1e-9},
                                                  {"Time [ms]", 1e-3},
                                                  {"time (us)", 1e-6},
                                                  {"elapsed/s", 1},
                                                  {"timeMs", 1e-3},
                                                  {"t_\xc2\xb5s", 1e-6},
                                                  {"status", 1},
                                                  {"forms", 1},
                                                  {"time-msec", 1e-3},
                                                  {"ms", 1e-3},
                                                  {"TIME_MS", 1e-3},
                                                  {"Time_Ms", 1e-3},
                                                  {"time_mS", 1e-3},
                                                  {"milliseconds", 1e-3},
                                                  {"Elapsed Microseconds", 1e-6},
                                                  {"time_millis", 1e-3},
                                                  {"t (msecs)", 1e-3},
                                                  {"Time [ms] since start", 1e-3},
                                                  {"Timems", 1e-3},
                                                  {"deviceTimeMSec", 1e-3},
                                                  {"timeMsUtc", 1e-3},
                                                  {"time_us_", 1e-6},
                                                  {"stamp.nsecs", 1e-9},
                                                  {"T [\xce\xbcS]", 1e-6},
                                                  {"seconds", 1},
                                                  {"timestamps", 1},
                                                  {"time (s) of day", 1},
                                                  {"t2ms", 1}};
  for (const auto& [name, unit] : names) {
    ReplayMotion settings;
    settings.time_column = name;
    const std::string text = std::string("x,y,z,") + name + "\n0,0,0,1000\n0.001,0,0,1200\n";
    EXPECT_NEAR(play(text, settings)->duration_s() / unit, 200, 1e-9) << name;
  }
}

TEST(TimeUnits, AreAskedForWhereANameHintsAtAnother) {
  for (const std::string name : {"time_min", "Time [h]", "ticks", "t [100 ns]", "time_100us", "ns_to_ms",
                                 "Time (UTC)", "Millisekunden"}) {
    ReplayMotion settings;
    settings.time_column = name;
    const std::string text = "# made today\nx;y;z;" + name + "\n0;0;0;1000\n0.001;0;0;1200\n";
    EXPECT_EQ(playError(text, settings), "log.csv:2: column \"" + name +
                                             "\" does not say clearly whether its unit is s, ms, us or ns, "
                                             "expected time_unit beside time_column");
    settings.time_unit = TimeUnit::ms;
    EXPECT_DOUBLE_EQ(play(text, settings)->duration_s(), 0.2) << name;
  }
}

TEST(TimeUnits, AreStatedWhereNoNameSaysThem) {
  ReplayMotion settings = timed();
  settings.time_unit = TimeUnit::us;
  const auto motion = play("t,x,y,z\n1700000000000000,0,0,0\n1700000000100000,0.01,0,0\n", settings);
  EXPECT_DOUBLE_EQ(motion->duration_s(), 0.1);
  settings.time_column = "t_ms";
  EXPECT_DOUBLE_EQ(play("t_ms,x,y,z\n0,0,0,0\n100000,0.01,0,0\n", settings)->duration_s(), 0.1)
      << "what is stated holds";
  EXPECT_EQ(playError("t_ms,x,y,z\n5,0,0,0\n4,0.01,0,0\n", settings),
            "log.csv:3: time goes back from 5 to 4 us in column \"t_ms\", expected rows in order of time");
}

// 12.8 mm in a millisecond: no jump by its length, but no hand is that fast.
TEST(FastSteps, AreNamedWithTheirLine) {
  const std::string text =
      "t,x,y,z\n0,0,0,0\n0.001,0.001,0,0\n0.002,0.0138,0,0\n0.003,0.0145,0,0\n0.004,0.0345,0,0\n";
  const auto motion = play(text, timed());
  EXPECT_EQ(count(*motion, "replay_fast_steps"), 2);
  EXPECT_EQ(count(*motion, "replay_jumps"), 0);
  ASSERT_EQ(motion->notes().size(), 1u);
  EXPECT_NE(motion->notes()[0].find("log.csv:4: a step of 12.8 mm in 1 ms, 12.8 m/s, is faster than "
                                    "jump_speed_m_s, 2 m/s: the first of 2, played as it is"),
            std::string::npos)
      << motion->notes()[0];
  ReplayMotion settings = timed();
  settings.jump_speed_m_s = 12.8;
  settings.jump_m = 0.0125;
  const auto both = play(text, settings);
  EXPECT_EQ(count(*both, "replay_fast_steps"), 1);
  EXPECT_EQ(count(*both, "replay_jumps"), 2);
  ASSERT_EQ(both->notes().size(), 2u);
  EXPECT_NE(both->notes()[0].find("is longer than jump_m, 12.5 mm: the first of 2"), std::string::npos);
  settings.end_s = 0.0015;
  EXPECT_EQ(count(*play(text, settings), "replay_fast_steps"), 0) << "played, but not so far";
}

TEST(Peaks, AreDifferencesOverTheStepsOfARun) {
  const auto motion = play("t,x,y,z\n0,0,0,0\n0.1,0.01,0,0\n0.2,0.05,0,0\n", timed());
  const MotionPeaks peaks = peaksOf(*motion, 0.01, 30);
  EXPECT_NEAR(peaks.speed_m_s(), 0.4, 1e-9);
  EXPECT_NEAR(peaks.acceleration_m_s2(), 40, 1e-6) << "from 0.4 m/s to rest in a step";
  EXPECT_TRUE(std::isnan(peaksOf(*motion, 0.01, 0).speed_m_s()));
  EXPECT_TRUE(std::isnan(peaksOf(*motion, 0.01, 1).acceleration_m_s2()));
  MotionPeaks lost(0.01);
  for (const double x : {0.0, 1.0, std::nan(""), 3.0, 3.0, 3.0}) lost.add(Vec3(x, 0, 0));
  EXPECT_TRUE(std::isnan(lost.speed_m_s()));
  EXPECT_TRUE(std::isnan(lost.acceleration_m_s2()));
}

}  // namespace
}  // namespace fissure::tracker_log_test
