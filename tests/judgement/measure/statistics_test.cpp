#include "measure/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "measure/final_state_probe.h"

namespace fissure::statistics_test {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Reference values from an independent implementation of FNV-1a.
TEST(StateHash, IsFnv1aOverLittleEndianDoubles) {
  EXPECT_EQ(stateHash({}, {}), "cbf29ce484222325");
  EXPECT_EQ(stateHash({Vec3(1, 2, 3)}, {Vec3(0, -1.5, 0)}), "e54d0f6ce1dd33e5");
  EXPECT_EQ(stateHash({Vec3(1, 2, 3)}, {Vec3(-0.0, -1.5, -0.0)}), "e54d0f6ce1dd33e5");
  EXPECT_NE(stateHash({Vec3(1, 2, 3)}, {Vec3(0, 1.5, 0)}), "e54d0f6ce1dd33e5");
  EXPECT_EQ(stateHash({Vec3(kNaN, 0, 0)}, {}), stateHash({Vec3(-kNaN, 0, 0)}, {}));
}

TEST(Statistics, RoughnessNeedsThreeValuesAndAForce) {
  Roughness roughness;
  EXPECT_TRUE(std::isnan(roughness.value()));
  for (int i = 0; i < 5; ++i) roughness.add(0.0);
  EXPECT_TRUE(std::isnan(roughness.value()));
  roughness.add(kNaN);
  EXPECT_TRUE(std::isnan(roughness.value()));
}

// A sine of angular frequency w per sample: the second difference is 2 - 2 cos(w) times the sine itself.
TEST(Statistics, RoughnessOfASine) {
  Roughness roughness;
  for (int i = 0; i < 200'000; ++i) roughness.add(std::sin(0.3 * i));
  EXPECT_NEAR(roughness.value(), 2 - 2 * std::cos(0.3), 1e-6);
}

// 1, 2, 1, 2, ...: second differences of 2, mean square 2.5; the other series only adds 4 to the mean square.
TEST(Statistics, RoughnessOfSeriesTakenTogether) {
  std::array<Roughness, 2> series;
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(std::isnan(Roughness::of(series)) || i >= 3) << i;
    series[0].add(i % 2 == 0 ? 1 : 2);
    series[1].add(2);
  }
  EXPECT_DOUBLE_EQ(Roughness::of(series), 2 / std::sqrt(6.5));
  EXPECT_DOUBLE_EQ(series[0].value(), 2 / std::sqrt(2.5));
  EXPECT_EQ(series[1].value(), 0);
  series[1].add(kNaN);
  EXPECT_TRUE(std::isnan(Roughness::of(series)));
}

TEST(Statistics, MaximumKeepsNaN) {
  RunningMax max;
  EXPECT_TRUE(std::isnan(max.value()));
  max.add(-3);
  EXPECT_EQ(max.value(), -3);
  max.add(kNaN);
  max.add(5);
  EXPECT_TRUE(std::isnan(max.value()));
}

TEST(Statistics, PercentileIsTheNearestRank) {
  EXPECT_TRUE(std::isnan(percentile({}, 50)));
  EXPECT_EQ(percentile({7}, 99), 7);
  EXPECT_EQ(percentile({3, 1, 2}, 50), 2);
  EXPECT_EQ(percentile({4, 3, 2, 1}, 50), 2);
  EXPECT_EQ(percentile({4, 3, 2, 1}, 51), 3);
}

}  // namespace
}  // namespace fissure::statistics_test
