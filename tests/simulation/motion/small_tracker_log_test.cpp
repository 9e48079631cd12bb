#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "motion/motion.h"
#include "scenario/load.h"
#include "temporary_log.h"

namespace fissure::small_tracker_log_test {

namespace {

const std::filesystem::path source = FISSURE_SOURCE_DIR;

TEST(SmallTrackerLog, PressesAndLiftsWithItsOddRowsCounted) {
  const Scenario scenario = loadScenario(source / "configs/replay_tracker.yaml").scenario;
  ASSERT_EQ(scenario.tools.size(), 1u);
  const auto motion = makeMotion(scenario.tools[0], scenario.directory);
  EXPECT_EQ(count(*motion, "replay_samples"), 57);
  EXPECT_EQ(count(*motion, "replay_filtered_rows"), 3);
  EXPECT_EQ(count(*motion, "replay_rows_beyond_reason"), 1);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 1);
  EXPECT_EQ(count(*motion, "replay_gaps"), 0);
  EXPECT_EQ(count(*motion, "replay_fast_steps"), 0);
  EXPECT_NEAR(motion->duration_s(), 61.0 / 60, 1e-12) << "the missing frame takes its time";
  for (const double time_s : {0.0, 0.45, 1.0})
    EXPECT_NEAR(motion->poseAt(time_s).orientation.angularDistance(Quat::Identity()), 0, 1e-6);
  EXPECT_NEAR((motion->poseAt(0).position_m - Vec3(0, 0.066, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((motion->poseAt(0.5).position_m - Vec3(0, 0.052, 0)).norm(), 0, 1e-9) << "14 mm down";
}

TEST(SmallTrackerLog, IsWhatItsScriptWrites) {
  if (!std::filesystem::exists("/usr/bin/python3")) GTEST_SKIP() << "there is no /usr/bin/python3";
  const std::string command =
      "/usr/bin/python3 \"" + (source / "scripts/make_tracker_log.py").string() + "\"";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string written;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) written += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0);
  std::ostringstream committed;
  committed << std::ifstream(source / "configs/logs/tracker_small.csv", std::ios::binary).rdbuf();
  EXPECT_EQ(written, committed.str());
}

}  // namespace
}  // namespace fissure::small_tracker_log_test
