#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "motion/motion.h"
#include "scenario/load.h"
#include "temporary_log.h"

namespace fissure {
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

TEST(SmallFalconLog, IsWhatItsScriptWrites) {
  if (!std::filesystem::exists("/usr/bin/python3")) GTEST_SKIP() << "there is no /usr/bin/python3";
  const std::string command = "/usr/bin/python3 \"" + (source / "scripts/make_falcon_log.py").string() + "\"";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string written;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) written += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0);
  std::ostringstream committed;
  committed << std::ifstream(source / "configs/logs/falcon_small.csv", std::ios::binary).rdbuf();
  EXPECT_EQ(written, committed.str());
}

}  // namespace
}  // namespace fissure
