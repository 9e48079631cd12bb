#include "report/series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace fissure::series_test {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A walk with spikes, gaps of every length and levels that it keeps for a while.
std::vector<double> walk(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> values(count);
  double level = 0;
  for (std::size_t row = 0; row < count; ++row) {
    const unsigned kind = random() % 100;
    if (kind < 50) level += static_cast<double>(random() % 1000) - 499.5;
    values[row] = kind == 99 ? 1e6 : kind >= 92 ? kNaN : level;
  }
  return values;
}

/// The slow oracle: in each span the extremes are there, looked for from scratch, and a gap where it has one.
void expectExtremesOf(const std::vector<double>& values, std::size_t buckets) {
  const std::vector<std::size_t> rows = extremeRows(values, buckets);
  ASSERT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  ASSERT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end()) << "a row twice";
  EXPECT_EQ(rows.front(), 0u);
  EXPECT_EQ(rows.back(), values.size() - 1);
  EXPECT_LE(rows.size(), std::max(3 * buckets + 2, values.size() <= 2 * buckets ? values.size() : 0));
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    std::vector<double> all, kept;
    for (std::size_t row = 0; row < values.size(); ++row) {
      if (row < bucket * values.size() / buckets || row >= (bucket + 1) * values.size() / buckets) continue;
      all.push_back(values[row]);
      if (std::binary_search(rows.begin(), rows.end(), row)) kept.push_back(values[row]);
    }
    const auto isMissing = [](double value) { return std::isnan(value); };
    EXPECT_EQ(std::any_of(all.begin(), all.end(), isMissing),
              std::any_of(kept.begin(), kept.end(), isMissing));
    std::erase_if(all, isMissing);
    std::erase_if(kept, isMissing);
    ASSERT_EQ(all.empty(), kept.empty());
    if (all.empty()) continue;
    EXPECT_EQ(*std::min_element(all.begin(), all.end()), *std::min_element(kept.begin(), kept.end()));
    EXPECT_EQ(*std::max_element(all.begin(), all.end()), *std::max_element(kept.begin(), kept.end()));
  }
}

TEST(Series, EverySpanKeepsItsExtremesAndItsGap) {
  for (unsigned seed = 0; seed < 20; ++seed)
    for (const std::size_t count : {1u, 2u, 7u, 100u, 999u, 5000u})
      for (const std::size_t buckets : {1u, 3u, 50u, 400u}) expectExtremesOf(walk(count, seed), buckets);
}

/// What a plot draws at a row: on the straight line between the kept points around it, unless one is missing.
double drawnAt(const ThinnedSeries& thinned, std::size_t row) {
  const auto after = std::lower_bound(thinned.rows.begin(), thinned.rows.end(), row);
  const auto right = static_cast<std::size_t>(after - thinned.rows.begin());
  if (thinned.rows[right] == row) return thinned.values[right];
  const double a = thinned.values[right - 1], b = thinned.values[right];
  const auto from = static_cast<double>(thinned.rows[right - 1]),
             to = static_cast<double>(thinned.rows[right]);
  return a == b ? a : a + (b - a) * (static_cast<double>(row) - from) / (to - from);
}

TEST(Series, DroppingEqualValuesChangesNoLine) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<double> values = walk(700, seed);
    const std::vector<std::size_t> rows = extremeRows(values, 60);
    const ThinnedSeries thinned = thinSeries(values, 60);
    for (const std::size_t row : rows) {
      const double drawn = drawnAt(thinned, row);
      EXPECT_TRUE(drawn == values[row] || (std::isnan(drawn) && std::isnan(values[row])))
          << "row " << row << ": " << drawn << " for " << values[row];
    }
    EXPECT_LE(thinned.rows.size(), rows.size());
  }
}

TEST(Series, AConstantIsTwoPoints) {
  const ThinnedSeries thinned = thinSeries(std::vector<double>(5000, 0.25), 300);
  EXPECT_EQ(thinned.rows, (std::vector<std::size_t>{0, 4999}));
  EXPECT_EQ(thinned.values, (std::vector<double>{0.25, 0.25}));
}

TEST(Series, OneRowOfASpikeOrAGapStays) {
  std::vector<double> values(5000, 1.0);
  values[3333] = -7;
  values[1234] = kNaN;
  const ThinnedSeries thinned = thinSeries(values, 100);
  for (const std::size_t row : {1234u, 3333u}) {
    const auto at = std::find(thinned.rows.begin(), thinned.rows.end(), row);
    ASSERT_NE(at, thinned.rows.end());
    const double value = thinned.values[static_cast<std::size_t>(at - thinned.rows.begin())];
    EXPECT_TRUE(row == 3333u ? value == -7 : std::isnan(value)) << value;
  }
}

TEST(Series, InfinityIsMissing) {
  const ThinnedSeries thinned = thinSeries({1, std::numeric_limits<double>::infinity(), 2}, 10);
  ASSERT_EQ(thinned.values.size(), 3u);
  EXPECT_TRUE(std::isnan(thinned.values[1]));
}

TEST(Series, NoRowsAreNoPoints) {
  EXPECT_TRUE(thinSeries({}, 10).rows.empty());
}

}  // namespace
}  // namespace fissure::series_test
