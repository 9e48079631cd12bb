#include "text/summary_unit.h"

#include <gtest/gtest.h>

namespace fissure::summary_unit_test {

namespace {

TEST(SummaryUnit, IsReadOffTheName) {
  EXPECT_EQ(summaryUnit("max_penetration_depth_m"), "m");
  EXPECT_EQ(summaryUnit("max_force_hc_N"), "N");
  EXPECT_EQ(summaryUnit("first_contact_time_s"), "s");
  EXPECT_EQ(summaryUnit("node_switch_rate_hz"), "Hz");
  EXPECT_EQ(summaryUnit("step_time_p99_us"), "us");
  EXPECT_EQ(summaryUnit("rays"), "1");
}

TEST(SummaryUnit, OfUnitsThatEndWithAnother) {
  EXPECT_EQ(summaryUnit("stiffness_N_m"), "N m-1");
  EXPECT_EQ(summaryUnit("damping_N_s_m"), "N s m-1");
  EXPECT_EQ(summaryUnit("speed_m_s"), "m s-1");
  EXPECT_EQ(summaryUnit("gravity_m_s2"), "m s-2");
  EXPECT_EQ(summaryUnit("air_density_kg_m3"), "kg m-3");
  EXPECT_EQ(summaryUnit("mass_kg"), "kg");
  EXPECT_EQ(summaryUnit("max_pressure_Pa"), "Pa");
  EXPECT_EQ(summaryUnit("viscosity_Pa_s"), "Pa s");
  EXPECT_EQ(summaryUnit("mass_damping_1_s"), "s-1");
  EXPECT_EQ(summaryUnit("field_of_view_deg"), "degree");
  EXPECT_EQ(summaryUnit("memory_mb"), "MiB");
}

TEST(SummaryUnit, OfOneNumberOfAList) {
  EXPECT_EQ(summaryUnit("start_m_1"), "m");
  EXPECT_EQ(summaryUnit("vertices_m_12_0"), "m");
  EXPECT_EQ(summaryUnit("size_px_0"), "pixel");
  EXPECT_EQ(summaryUnit("resolution_0"), "1");
  EXPECT_EQ(summaryUnit("12"), "1");
}

TEST(SummaryUnit, IsLeftOutOfTheName) {
  EXPECT_EQ(withoutUnit("damping_N_s_m"), "damping");
  EXPECT_EQ(withoutUnit("tool_a_start_m_1"), "tool_a_start_1");
  EXPECT_EQ(withoutUnit("rays"), "rays");
  EXPECT_EQ(withoutUnit("m"), "m");
  EXPECT_EQ(withoutUnit("_m"), "_m");
}

}  // namespace
}  // namespace fissure::summary_unit_test
