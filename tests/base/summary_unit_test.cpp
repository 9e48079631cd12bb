#include "base/summary_unit.h"

#include <gtest/gtest.h>

namespace fissure {
namespace {

TEST(SummaryUnit, IsReadOffTheName) {
  EXPECT_EQ(summaryUnit("max_penetration_depth_m"), "m");
  EXPECT_EQ(summaryUnit("max_force_hc_N"), "N");
  EXPECT_EQ(summaryUnit("first_contact_time_s"), "s");
  EXPECT_EQ(summaryUnit("node_switch_rate_hz"), "Hz");
  EXPECT_EQ(summaryUnit("step_time_p99_us"), "us");
  EXPECT_EQ(summaryUnit("rays"), "1");
}

}  // namespace
}  // namespace fissure
