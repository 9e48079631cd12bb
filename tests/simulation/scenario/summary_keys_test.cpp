#include "scenario/summary_keys.h"

#include <gtest/gtest.h>

#include "scenario_text.h"

namespace fissure::summary_keys_test {

namespace {

std::string clampText(const std::string& name) {
  return "  - name: " + name +
         "\n"
         "    shape: {type: box, size_m: [0.004, 0.04, 0.01]}\n"
         "    clamp: {opening: parallel, jaw_position_m: [0.002, 0, 0]}\n"
         "    motion: {type: script, start_m: [0, 0.1, 0], start_opening_m: 0.08}\n";
}

std::string problemOf(const std::string& tools_and_laws) {
  return inputError([&] { parseScenario(smallest_text + tools_and_laws, "s.yaml"); });
}

TEST(SummaryKeys, TwoClampsAndTwoLawsMayMakeOneKey) {
  const std::string first = "force:\n  - {name: y, model: linear_elastic, k: 10}\n";
  const std::string second = "  - {name: x_left_max_force_y, model: linear_elastic, k: 10}\n";
  const std::string tools = "tools:\n" + clampText("clamp") + clampText("clamp_left_max_force_x");
  EXPECT_EQ(problemOf(tools + first + second),
            "s.yaml:10: tools.clamp makes the summary's key \"clamp_left_max_force_x_left_max_force_y_N\", "
            "and so do other names, expected a key for each value (beside force.x_left_max_force_y at "
            "s.yaml:20, tools.clamp_left_max_force_x at s.yaml:14, force.y at s.yaml:19)");
  EXPECT_EQ(problemOf(tools + first), "nothing");
  EXPECT_EQ(problemOf("tools:\n" + clampText("clamp") + first + second), "nothing");
}

TEST(SummaryKeys, ALawMayMakeTheKeyOfAClamp) {
  EXPECT_NE(problemOf("tools:\n" + clampText("max_force_a") +
                      "force:\n  - {name: b, model: linear_elastic, k: 10}\n"
                      "  - {name: a_max_resultant_b, model: linear_elastic, k: 10}\n")
                .find("\"max_force_a_max_resultant_b_N\""),
            std::string::npos);
}

}  // namespace
}  // namespace fissure::summary_keys_test
