#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "motion/motion.h"
#include "temporary_log.h"

namespace fissure::recorded_logs_test {

namespace {

/// Real logs may not be committed. FISSURE_LOGS names a folder that has them.
class RecordedLogs : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("FISSURE_LOGS");
    if (!folder) GTEST_SKIP() << "FISSURE_LOGS names no folder with recorded logs";
    folder_ = folder;
  }

  /// All cells of a log, read without the code under test. The files have no empty cells.
  std::vector<std::vector<double>> rows(const std::string& name) const {
    std::ifstream in(folder_ / name);
    std::vector<std::vector<double>> rows;
    std::string line, cell;
    std::getline(in, line);
    while (std::getline(in, line)) {
      std::istringstream cells(line);
      rows.emplace_back();
      while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
    }
    return rows;
  }

  std::unique_ptr<Motion> play(const ReplayMotion& settings) const {
    ToolSettings tool;
    tool.name = "hand";
    tool.motion = settings;
    return makeMotion(tool, folder_);
  }

  std::filesystem::path folder_;
};

ReplayMotion falcon() {
  ReplayMotion settings;
  settings.file = "falcon_session_A.csv";
  settings.time_column = "t_s_nominal100Hz";
  settings.position_columns = {"x_m", "y_m", "z_m"};
  return settings;
}

TEST_F(RecordedLogs, FalconPositionsAreReplayedThroughAMapping) {
  ReplayMotion settings = falcon();
  settings.mapping.axes = {"-z", "y", "x"};
  settings.mapping.scale = 1.5;
  settings.mapping.origin_device_m = {0.0015, -0.0015, 0.105};
  settings.mapping.origin_scene_m = {0.1, 0.2, 0.3};
  for (const auto interpolation : {Interpolation::linear, Interpolation::monotone_cubic}) {
    settings.interpolation = interpolation;
    const auto motion = play(settings);
    const auto samples = rows(settings.file);
    ASSERT_EQ(samples.size(), 8513u);
    EXPECT_EQ(count(*motion, "replay_samples"), 8513);
    EXPECT_EQ(count(*motion, "replay_dropped_rows"), 0);
    EXPECT_GT(count(*motion, "replay_held_samples"), 8300);  // 98.6 % frozen
    EXPECT_EQ(count(*motion, "replay_gaps"), 0);
    for (const auto& row : samples) {
      const Vec3 wanted(0.1 - 1.5 * (row[3] - 0.105), 0.2 + 1.5 * (row[2] + 0.0015),
                        0.3 + 1.5 * (row[1] - 0.0015));
      ASSERT_LT((motion->poseAt(row[0]).position_m - wanted).norm(), 1e-9);
    }
  }
}

// As the driver dumped it: one line an axis, of which one is a sample shorter than the others.
TEST_F(RecordedLogs, FalconAsItsRawTextIsTheSame) {
  ReplayMotion raw;
  raw.file = "falcon_session_A_position.txt";
  raw.layout = LogLayout::axes;
  raw.rate_hz = 100;
  const auto motion = play(raw), rows = play(falcon());
  EXPECT_EQ(count(*motion, "replay_samples"), 8513);
  EXPECT_GE(count(*motion, "replay_dropped_rows"), 1);
  EXPECT_EQ(count(*motion, "replay_held_samples"), count(*rows, "replay_held_samples"));
  for (int i = 0; i < 8513; ++i)
    ASSERT_LT((motion->poseAt(0.01 * i).position_m - rows->poseAt(0.01 * i).position_m).norm(), 1e-12) << i;
}

TEST_F(RecordedLogs, FalconForcesFollowFromReplayedPositions) {
  // What the recorder did: a spring of 55 N/m to P0. Nobody here wrote these force columns.
  const auto motion = play(falcon());
  const Vec3 rest_m(0.0015114, -0.0015228, 0.1047600);
  for (const auto& row : rows(falcon().file)) {
    const Vec3 force_N = 55.0 * (rest_m - motion->poseAt(row[0]).position_m);
    ASSERT_LT((force_N - Vec3(row[4], row[5], row[6])).cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST_F(RecordedLogs, FalconWithoutItsTimeColumnRunsAtItsRate) {
  ReplayMotion settings = falcon();
  settings.time_column.reset();
  settings.rate_hz = 100;
  const auto timed = play(falcon()), rated = play(settings);
  EXPECT_NEAR(timed->duration_s(), rated->duration_s(), 1e-9);
  for (double time_s = 0; time_s < timed->duration_s(); time_s += 0.0037)
    ASSERT_LT((timed->poseAt(time_s).position_m - rated->poseAt(time_s).position_m).norm(), 1e-9);
}

TEST_F(RecordedLogs, PalpationIsMillimetresQuaternionsAndIrregularTime) {
  ReplayMotion settings;
  settings.file = "palpation_trial5.csv";
  settings.time_column = "t_s";
  settings.position_columns = {"x_mm", "y_mm", "z_mm"};
  settings.position_unit = LengthUnit::mm;
  settings.quaternion_columns = {"q1", "q2", "q3", "q0"};
  const auto motion = play(settings);
  const auto samples = rows(settings.file);
  EXPECT_EQ(count(*motion, "replay_samples") + count(*motion, "replay_repeated_rows"), 13446);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 0);
  EXPECT_EQ(count(*motion, "replay_gaps"), 0);  // 120 ms at most
  double last_s = -1;
  for (const auto& row : samples) {
    if (row[0] == last_s) continue;
    last_s = row[0];
    const Pose pose = motion->poseAt(row[0] - samples[0][0]);
    ASSERT_LT((pose.position_m - Vec3(row[1], row[2], row[3]) / 1000).norm(), 1e-9);
    const Quat wanted = Quat(row[7], row[8], row[9], row[10]).normalized();
    ASSERT_LT(1 - std::abs(pose.orientation.dot(wanted)), 1e-12);
  }
}

}  // namespace
}  // namespace fissure::recorded_logs_test
