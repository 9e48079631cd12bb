#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "motion/motion.h"
#include "scenario/load.h"
#include "temporary_log.h"

namespace fissure::small_palpation_log_test {

namespace {

const std::filesystem::path source = FISSURE_SOURCE_DIR;

TEST(SmallPalpationLog, PalpatesTheSphereWithItsOddRowsCounted) {
  const Scenario scenario = loadScenario(source / "configs/replay_palpation.yaml").scenario;
  ASSERT_EQ(scenario.tools.size(), 1u);
  const auto motion = makeMotion(scenario.tools[0], scenario.directory);
  EXPECT_EQ(count(*motion, "replay_samples"), 195);
  EXPECT_EQ(count(*motion, "replay_gaps"), 1) << "0.3 s; the one of 0.12 s is bridged";
  EXPECT_EQ(count(*motion, "replay_dropped_rows"), 1);
  const Pose first = motion->poseAt(0);
  EXPECT_NEAR((first.position_m - Vec3(0, 0.065, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR(first.orientation.angularDistance(Quat::Identity()), 0, 1e-5) << "the blade lies flat";
  double lowest_m = 1, tilt_rad = 0;
  for (int step = 0; step <= 3363; ++step) {
    const Pose pose = motion->poseAt(0.001 * step);
    lowest_m = std::min(lowest_m, pose.position_m.y());
    tilt_rad = std::max(tilt_rad, pose.orientation.angularDistance(Quat::Identity()));
  }
  EXPECT_NEAR(lowest_m, 0.065 - 0.010, 0.0002) << "7 mm and 3 mm";
  EXPECT_NEAR(tilt_rad, 3 * 3.14159265 / 180, 0.001);
}

TEST(SmallPalpationLog, IsWhatItsScriptWrites) {
  if (!std::filesystem::exists("/usr/bin/python3")) GTEST_SKIP() << "there is no /usr/bin/python3";
  const std::string command =
      "/usr/bin/python3 \"" + (source / "scripts/make_palpation_log.py").string() + "\"";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string written;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) written += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0);
  std::ostringstream committed;
  committed << std::ifstream(source / "configs/logs/palpation_small.csv", std::ios::binary).rdbuf();
  EXPECT_EQ(written, committed.str());
}

}  // namespace
}  // namespace fissure::small_palpation_log_test
