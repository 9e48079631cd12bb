#include "fit/depth_rates.h"

#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace fissure::depth_rates_test {

namespace {

using Numbers = std::vector<double>;

double rootMeanSquare(const Numbers& values) {
  double squares = 0;
  for (const double value : values) squares += value * value;
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : std::sqrt(squares / static_cast<double>(values.size()));
}

TEST(DepthRates, LieBetweenTheSlopesToBothNeighbours) {
  // d = t^2 at uneven times: exact inside, by the parabola; at the ends the slope to the neighbour.
  const Numbers rates = ratesOf({0, 1, 3, 4}, {0, 1, 9, 16});
  EXPECT_NEAR(rates[0], 1, 1e-14);
  EXPECT_NEAR(rates[1], 2, 1e-14);
  EXPECT_NEAR(rates[2], 6, 1e-14);
  EXPECT_NEAR(rates[3], 7, 1e-14);
  // A step that only grows has no negative rate anywhere.
  for (const double rate : ratesOf({0, 1, 1.01, 2, 3}, {0, 0, 1, 1, 1})) EXPECT_GE(rate, 0);
  // Points of one time count as their mean; one time has no rate.
  EXPECT_EQ(ratesOf({0, 1, 1, 2}, {0, 0.5, 1.5, 2}), (Numbers{1, 1, 1, 1}));
  EXPECT_EQ(ratesOf({5, 5}, {0, 1}), (Numbers{0, 0}));
}

TEST(DepthRates, NoiseIsWhatTheRatesOfNoisyDepthsAreOffBy) {
  // Presses at uneven steps of 0.5 to 1.5 ms, with 10 um of noise: its share in the rates is known.
  boost::random::mt19937_64 random(11);
  boost::random::normal_distribution<double> normal(0, 1);
  Numbers time_s, exact_m, noisy_m;
  for (int i = 0; i < 2000; ++i) {
    time_s.push_back(0.001 * i + 0.00025 * std::sin(7.0 * i));
    exact_m.push_back(0.003 * std::pow(std::sin(std::numbers::pi * time_s.back() / 0.1), 2));
    noisy_m.push_back(exact_m.back() + 1e-5 * normal(random));
  }
  Numbers off_m_s = ratesOf(time_s, noisy_m);
  const Numbers exact_m_s = ratesOf(time_s, exact_m);
  for (std::size_t i = 0; i < off_m_s.size(); ++i) off_m_s[i] -= exact_m_s[i];
  EXPECT_NEAR(rootMeanSquare(rateNoiseOf(time_s, noisy_m)) / rootMeanSquare(off_m_s), 1, 0.1);
  EXPECT_LT(rootMeanSquare(rateNoiseOf(time_s, exact_m)), 1e-3 * rootMeanSquare(exact_m_s));
}

TEST(DepthRates, ACubicHasNoNoiseAndEqualTimesCountAsOne) {
  for (const double noise : rateNoiseOf({0, 1, 1.5, 3, 4, 5}, {0, 1, 3.375, 27, 64, 125}))
    EXPECT_NEAR(noise, 0, 1e-12);
  for (const double noise : rateNoiseOf({0, 1, 1, 2, 3, 4}, {0, 0.5, 1.5, 2, 3, 4}))
    EXPECT_NEAR(noise, 0, 1e-12);
  EXPECT_EQ(rateNoiseOf({0, 1, 2, 3, 3}, {0, 5, 1, 4, 2}), (Numbers{0, 0, 0, 0, 0}));  // four times
  EXPECT_TRUE(rateNoiseOf({}, {}).empty());
  // By hand: 1, -4, 6, -4, 1 over the root of 70 finds 6 / root 70; a central slope has root 1/2 of it.
  const Numbers bump = rateNoiseOf({0, 1, 2, 3, 4}, {0, 0, 1, 0, 0});
  EXPECT_NEAR(bump[2], 6 / std::sqrt(70.0) * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(bump[0], 6 / std::sqrt(70.0) * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace fissure::depth_rates_test
