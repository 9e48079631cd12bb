#include "law/force_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fissure::force_law_test {

namespace {

TEST(HuntCrossley, IsTheFormulaOfThePaper) {
  const auto law = ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3});
  const LawForce force = law.at(0.01, 0.1);
  EXPECT_DOUBLE_EQ(force.elastic_N, 200 * std::pow(0.01, 1.3));
  EXPECT_DOUBLE_EQ(force.viscous_N, 50 * std::pow(0.01, 1.3) * 0.1);
  EXPECT_FALSE(force.adhesion_clamped);
}

TEST(HuntCrossley, IsZeroWithoutDeformation) {
  const auto law = ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3});
  for (const double x : {0.0, -1e-3}) {
    EXPECT_EQ(law.at(x, 3).elastic_N, 0);
    EXPECT_EQ(law.at(x, 3).viscous_N, 0);
  }
}

TEST(HuntCrossley, NeverPullsAndSaysWhenItWouldHave) {
  // k + lambda x' < 0 for x' < -k / lambda = -4 m/s.
  const auto law = ForceLaw(ForceModel::hunt_crossley, {.k = 200, .lambda = 50, .n = 1.3});
  EXPECT_FALSE(law.at(0.01, -3.9).adhesion_clamped);
  EXPECT_GT(law.at(0.01, -3.9).elastic_N + law.at(0.01, -3.9).viscous_N, 0);
  const LawForce pulled = law.at(0.01, -4.1);
  EXPECT_TRUE(pulled.adhesion_clamped);
  EXPECT_EQ(pulled.elastic_N + pulled.viscous_N, 0);
}

TEST(HuntCrossley, WithoutDampingAndWithExponentOneIsLinearElastic) {
  const auto hunt_crossley = ForceLaw(ForceModel::hunt_crossley, {.k = 300, .lambda = 0, .n = 1});
  const auto linear = ForceLaw(ForceModel::linear_elastic, {.k = 300});
  for (const double x : {0.0, 1e-6, 0.004, 0.3}) {
    EXPECT_DOUBLE_EQ(hunt_crossley.at(x, -2).elastic_N, linear.at(x, -2).elastic_N);
    EXPECT_EQ(linear.at(x, -2).viscous_N, 0);
  }
}

// A spring and a damper side by side: k x + c x', from x = 0 on; below it nothing.
TEST(KelvinVoigt, IsSpringPlusDamper) {
  const auto law = ForceLaw(ForceModel::kelvin_voigt, {.k = 300, .c = 7});
  EXPECT_DOUBLE_EQ(law.at(0.01, 0.1).elastic_N, 3);
  EXPECT_DOUBLE_EQ(law.at(0.01, 0.1).viscous_N, 0.7);
  EXPECT_DOUBLE_EQ(law.at(0, 0.1).viscous_N, 0.7) << "a damper needs no deformation";
  EXPECT_EQ(law.at(-1e-9, 0.1).viscous_N, 0);
  EXPECT_DOUBLE_EQ(law.at(0.004, 5).elastic_N,
                   ForceLaw(ForceModel::linear_elastic, {.k = 300}).at(0.004, 5).elastic_N);
}

TEST(KelvinVoigt, NeverPullsAndSaysWhenItWouldHave) {
  // k x + c x' < 0 for x' < -k x / c = -3 / 7 m/s.
  const auto law = ForceLaw(ForceModel::kelvin_voigt, {.k = 300, .c = 7});
  EXPECT_FALSE(law.at(0.01, -0.42).adhesion_clamped);
  EXPECT_NEAR(law.at(0.01, -0.42).elastic_N + law.at(0.01, -0.42).viscous_N, 0.06, 1e-12);
  const LawForce pulled = law.at(0.01, -0.43);
  EXPECT_TRUE(pulled.adhesion_clamped);
  EXPECT_EQ(pulled.elastic_N, 0);
  EXPECT_EQ(pulled.viscous_N, 0);
}

}  // namespace
}  // namespace fissure::force_law_test
