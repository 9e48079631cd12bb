#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "motion/motion.h"
#include "scenario/load.h"
#include "temporary_log.h"

namespace fissure::small_falcon_log_test {

namespace {

const std::filesystem::path source = FISSURE_SOURCE_DIR;

TEST(SmallFalconLog, PressesTheBladeIntoTheSphereAndComesBack) {
  const Scenario scenario = loadScenario(source / "configs/replay_falcon.yaml").scenario;
  ASSERT_EQ(scenario.tools.size(), 1u);
  const auto motion = makeMotion(scenario.tools[0], scenario.directory);
  EXPECT_DOUBLE_EQ(motion->duration_s(), 2.0);
  EXPECT_EQ(count(*motion, "replay_samples"), 201);
  EXPECT_EQ(count(*motion, "replay_gaps"), 0);
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 0);
  EXPECT_EQ(count(*motion, "replay_held_samples"), 7 + 26 + 4);  // FROZEN_ROWS of the script
  double lowest_m = 1;
  for (int step = 0; step <= 2000; ++step)
    lowest_m = std::min(lowest_m, motion->poseAt(0.001 * step).position_m.y());
  // The sphere's top is at 60 mm, half the blade's thickness 1 mm; a tremor of 0.15 mm on the depth of 25 mm.
  EXPECT_NEAR(lowest_m - 0.001, 0.06 - 0.025, 0.0002);
  for (const double time_s : {0.0, 2.0}) EXPECT_NEAR(motion->poseAt(time_s).position_m.y(), 0.071, 0.0002);
}

TEST(SmallFalconLog, MovesTheClampInAPlaneClosesAndLifts) {
  const Scenario scenario = loadScenario(source / "configs/clamp_vessel.yaml").scenario;
  const auto motion = makeMotion(scenario.tools.at(0), scenario.directory);
  EXPECT_EQ(count(*motion, "replay_held_samples"), 7 + 26 + 4);
  EXPECT_GT(count(*motion, "replay_saturated_openings"), 0);
  double lowest_m = 1, narrowest_deg = 180;
  for (int step = 0; step <= 2000; ++step) {
    const Pose pose = motion->poseAt(0.001 * step);
    EXPECT_EQ(pose.position_m.z(), 0);
    lowest_m = std::min(lowest_m, pose.position_m.y());
    narrowest_deg = std::min(narrowest_deg, motion->openingAt(0.001 * step));
  }
  EXPECT_NEAR(lowest_m, 0.05 - 0.04, 0.0002);
  EXPECT_NEAR(motion->poseAt(2).position_m.y(), 0.05 - 0.04 + 0.045, 0.0002);
  EXPECT_EQ(motion->openingAt(0.5), 36) << "beyond its limit";
  EXPECT_NEAR(narrowest_deg, 36 * (20 - 10.5) / 20, 0.2);
}

struct Made {
  const char *argument, *file;
};

TEST(SmallFalconLog, IsWhatItsScriptWrites) {
  if (!std::filesystem::exists("/usr/bin/python3")) GTEST_SKIP() << "there is no /usr/bin/python3";
  for (const Made& made : {Made{"", "falcon_small.csv"}, Made{" clamp", "falcon_clamp.csv"}}) {
    const std::string command =
        "/usr/bin/python3 \"" + (source / "scripts/make_falcon_log.py").string() + "\"";
    FILE* pipe = popen((command + made.argument).c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string written;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) written += static_cast<char>(c);
    EXPECT_EQ(pclose(pipe), 0);
    std::ostringstream committed;
    committed << std::ifstream(source / "configs/logs" / made.file, std::ios::binary).rdbuf();
    EXPECT_EQ(written, committed.str()) << made.file;
  }
}

}  // namespace
}  // namespace fissure::small_falcon_log_test
