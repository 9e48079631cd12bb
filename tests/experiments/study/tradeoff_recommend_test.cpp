#include "study/tradeoff_recommend.h"

#include <gtest/gtest.h>

#include "files/temporary_folder.h"
#include "files/write_file.h"
#include "scenario/load.h"

namespace fissure::tradeoff_recommend_test {

TEST(TradeoffRecommend, IsTheScenarioWithItsSettingFromAnotherFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path base = std::filesystem::path(FISSURE_SOURCE_DIR) / "configs/organ_press.yaml";
  const std::vector<Override> overrides{{"time.step_s", "0.002"},
                                        {"tools.spatula.motion.segments.0.speed_m_s", "0.3"}};
  const LoadedScenario expected = loadScenario(base, overrides);
  const std::string pipeline = expected.scenario.pipelines.back().name;
  const std::filesystem::path file = folder.path() / "found.yaml";
  writeFile(file, recommendedText(base, file, pipeline, overrides, {"one", "two"}));
  const LoadedScenario found = loadScenario(file);
  EXPECT_TRUE(found.source.starts_with("# one\n# two\n"));
  ASSERT_EQ(found.scenario.pipelines.size(), 1u);
  EXPECT_EQ(found.scenario.pipelines.front().name, pipeline);
  EXPECT_TRUE(found.scenario.expect.empty());
  // All else is equal, and the mesh is the same file.
  ASSERT_GE(found.inputs.size(), 2u);
  EXPECT_TRUE(std::filesystem::equivalent(found.inputs.back(), expected.inputs.back()));
  Scenario a = found.scenario, b = expected.scenario;
  EXPECT_EQ(a.time.step_s, 0.002);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.tools, b.tools);
}

}  // namespace fissure::tradeoff_recommend_test
