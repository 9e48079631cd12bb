#include "study/stability_signal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace fissure {
namespace {

constexpr double kStep_s = 0.001;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// offset + slope t + amplitude exp(-decay t) sin(2 pi f t)
std::vector<double> wave(int count, double offset, double slope, double amplitude, double frequency_Hz,
                         double decay_1_s = 0) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double t = i * kStep_s;
    values.push_back(offset + slope * t +
                     amplitude * std::exp(-decay_1_s * t) *
                         std::sin(2 * std::numbers::pi * frequency_Hz * t));
  }
  return values;
}

std::optional<Chatter> chatter(const std::vector<double>& signal) {
  return chatterOf(signal, kStep_s, 1, 0.1, 6);
}

TEST(StabilitySignal, FindsTheFrequencyOfAnOscillationBesideATrend) {
  for (const double frequency_Hz : {40.0, 100.0, 333.0}) {
    const auto found = chatter(wave(300, 1, 0.5, 0.4, frequency_Hz));
    ASSERT_TRUE(found) << frequency_Hz;
    EXPECT_NEAR(found->frequency_Hz, frequency_Hz, 0.03 * frequency_Hz);
    EXPECT_NEAR(found->share, 0.4 / std::sqrt(2) / 1.075, 0.01);
  }
}

TEST(StabilitySignal, AnAlternationFromStepToStepHasHalfTheRateOfSteps) {
  std::vector<double> values;
  for (int i = 0; i < 60; ++i) values.push_back(i % 2 == 0 ? 1 : 3);
  const auto found = chatter(values);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->frequency_Hz, 500, 1e-6);
}

TEST(StabilitySignal, SmallSlowAndDyingOscillationsAreNoChatter) {
  EXPECT_FALSE(chatter(wave(300, 1, 0, 0.13, 100)));       // 9 % RMS
  EXPECT_TRUE(chatter(wave(300, 1, 0, 0.15, 100)));        // 11 %
  EXPECT_FALSE(chatter(wave(300, 1, 0, 0.4, 8)));          // four crossings
  EXPECT_FALSE(chatter(wave(300, 1, 0, 0.8, 100, 20)));    // a sixth is left in the last third
  EXPECT_TRUE(chatter(wave(300, 1, 0, 0.8, 100, 1)));      // four fifths are
  EXPECT_FALSE(chatter(wave(300, 1, 5, 0, 1)));            // a trend alone
  EXPECT_FALSE(chatter(wave(300, 0.001, 0, 0.001, 100)));  // below 1 % of the peak
}

TEST(StabilitySignal, WithoutEnoughFiniteSamplesThereIsNoChatter) {
  EXPECT_FALSE(chatter({}));
  EXPECT_FALSE(chatter(wave(11, 1, 0, 0.5, 400)));
  std::vector<double> broken = wave(300, 1, 0, 0.5, 100);
  broken[7] = kNoNumber;
  EXPECT_FALSE(chatter(broken));
  EXPECT_FALSE(chatter(std::vector<double>(300, 0)));
}

/// Energy of a growing or dying vibration.
std::vector<double> energy(double rate_1_s, double first_J = 1e-4) {
  std::vector<double> values;
  for (int i = 0; i < 90; ++i) {
    const double s = std::sin(0.9 * i);
    values.push_back(first_J * std::exp(rate_1_s * i * kStep_s) * s * s);
  }
  return values;
}

TEST(StabilitySignal, GrowthIsThatBetweenTheThirds) {
  const auto growth = growthOf(energy(100), 1e-3);
  ASSERT_TRUE(growth);
  EXPECT_NEAR(std::log(*growth), 100 * 0.06, 0.4);
  EXPECT_LT(growthOf(energy(10), 1e-3).value_or(0), 3);
}

TEST(StabilitySignal, DyingTinyAndSingleBurstsOfEnergyDoNotGrow) {
  EXPECT_FALSE(growthOf(energy(-50), 1e-3));
  EXPECT_FALSE(growthOf(energy(100, 1e-20), 1e-3));  // rounding
  EXPECT_FALSE(growthOf(energy(100), 0));            // nothing moved before
  std::vector<double> burst(90, 1e-6);
  burst[45] = 1e-2;
  EXPECT_FALSE(growthOf(burst, 1e-3));
}

TEST(StabilitySignal, WithoutEnoughFiniteSamplesThereIsNoGrowth) {
  EXPECT_FALSE(growthOf({}, 1));
  std::vector<double> broken = energy(100);
  broken[3] = kNoNumber;
  EXPECT_FALSE(growthOf(broken, 1e-3));
  broken[3] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(growthOf(broken, 1e-3));
}

}  // namespace
}  // namespace fissure
