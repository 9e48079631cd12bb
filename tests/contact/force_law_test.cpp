#include "contact/force_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fissure {
namespace {

TEST(HuntCrossley, IsTheFormulaOfThePaper) {
  const auto law = makeHuntCrossley(200, 50, 1.3);
  const LawForce force = law->at(0.01, 0.1);
  EXPECT_DOUBLE_EQ(force.elastic_N, 200 * std::pow(0.01, 1.3));
  EXPECT_DOUBLE_EQ(force.viscous_N, 50 * std::pow(0.01, 1.3) * 0.1);
  EXPECT_FALSE(force.adhesion_clamped);
}

TEST(HuntCrossley, IsZeroWithoutDeformation) {
  const auto law = makeHuntCrossley(200, 50, 1.3);
  for (const double x : {0.0, -1e-3}) {
    EXPECT_EQ(law->at(x, 3).elastic_N, 0);
    EXPECT_EQ(law->at(x, 3).viscous_N, 0);
  }
}

TEST(HuntCrossley, NeverPullsAndSaysWhenItWouldHave) {
  // k + lambda x' < 0 for x' < -k / lambda = -4 m/s.
  const auto law = makeHuntCrossley(200, 50, 1.3);
  EXPECT_FALSE(law->at(0.01, -3.9).adhesion_clamped);
  EXPECT_GT(law->at(0.01, -3.9).elastic_N + law->at(0.01, -3.9).viscous_N, 0);
  const LawForce pulled = law->at(0.01, -4.1);
  EXPECT_TRUE(pulled.adhesion_clamped);
  EXPECT_EQ(pulled.elastic_N + pulled.viscous_N, 0);
}

TEST(HuntCrossley, WithoutDampingAndWithExponentOneIsLinearElastic) {
  const auto hunt_crossley = makeHuntCrossley(300, 0, 1);
  const auto linear = makeLinearElastic(300);
  for (const double x : {0.0, 1e-6, 0.004, 0.3}) {
    EXPECT_DOUBLE_EQ(hunt_crossley->at(x, -2).elastic_N, linear->at(x, -2).elastic_N);
    EXPECT_EQ(linear->at(x, -2).viscous_N, 0);
  }
}

struct Impact {
  double a, x_max_mm, speed_ratio;
};

// A mass of 0.05 kg hits a Hunt-Crossley wall (k 2000, n 1.5) at 0.5 m/s; closed forms for depth and rebound
// (Hunt and Crossley 1975). Integrated here with classical Runge-Kutta at 1 us through the law under test.
TEST(HuntCrossley, ReproducesTheClosedFormImpact) {
  const double m = 0.05, k = 2000, n = 1.5, v0 = 0.5, h = 1e-6;
  for (const Impact& expected :
       {Impact{0.1, 8.94216, 0.967739}, {0.5, 8.52698, 0.856851}, {1.5, 7.75053, 0.662962}}) {
    const auto law = makeHuntCrossley(k, expected.a * k, n);
    const auto acceleration = [&](double x, double v) {
      const LawForce force = law->at(x, v);
      return -(force.elastic_N + force.viscous_N) / m;
    };
    double x = 0, v = v0, x_max = 0;
    do {
      const double k1x = v, k1v = acceleration(x, v);
      const double k2x = v + 0.5 * h * k1v, k2v = acceleration(x + 0.5 * h * k1x, v + 0.5 * h * k1v);
      const double k3x = v + 0.5 * h * k2v, k3v = acceleration(x + 0.5 * h * k2x, v + 0.5 * h * k2v);
      const double k4x = v + h * k3v, k4v = acceleration(x + h * k3x, v + h * k3v);
      x += h / 6 * (k1x + 2 * k2x + 2 * k3x + k4x);
      v += h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
      x_max = std::max(x_max, x);
    } while (x > 0);
    EXPECT_NEAR(1000 * x_max, expected.x_max_mm, 1e-5);
    EXPECT_NEAR(-v / v0, expected.speed_ratio, 1e-5);
  }
}

}  // namespace
}  // namespace fissure
