#include "compare/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace fissure::difference_test {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Difference differenceOf(const std::vector<double>& a, const std::vector<double>& b, std::size_t columns = 1,
                        const DifferenceRules& rules = {}) {
  DifferenceMeter meter(columns, rules);
  meter.add(a, b);
  return meter.result();
}

std::vector<std::size_t> same(std::size_t rows) {
  std::vector<std::size_t> partners(rows);
  std::iota(partners.begin(), partners.end(), std::size_t{0});
  return partners;
}

TEST(Difference, OfOneValueAmongMillionsIsTheLargest) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> numbers(-1, 1);
  std::vector<double> a(3 * 400'000);
  for (double& value : a) value = numbers(random);
  std::vector<double> b = a;
  b[3 * 123'456 + 2] += 1e-6;
  b[3 * 300'000] -= 1e-7;
  DifferenceMeter meter(3, {});
  for (std::size_t row = 0; row < 400'000; row += 1000)
    meter.add(std::span(a).subspan(3 * row, 3000), std::span(b).subspan(3 * row, 3000));
  const Difference& found = meter.result();
  EXPECT_NEAR(found.largest, 1e-6, 1e-15);
  EXPECT_EQ(found.worst, (ValueIndex{123'456, 2}));
  EXPECT_EQ(found.first, (ValueIndex{123'456, 2}));
  EXPECT_EQ(found.count, 2u);
  EXPECT_EQ(meter.firstRowBeyond(5e-8), 123'456u);
  EXPECT_EQ(meter.firstRowBeyond(2e-6), std::nullopt);
}

TEST(Difference, FirstAndWorstAreDifferentPlaces) {
  const Difference found = differenceOf({0, 1, 2, 3, 4, 5}, {0, 1.5, 2, 3, 4, -5}, 2);
  EXPECT_EQ(found.first, (ValueIndex{0, 1}));
  EXPECT_EQ(found.worst, (ValueIndex{2, 1}));
  EXPECT_EQ(found.largest, 10);
  EXPECT_EQ(found.largest_a, 5);
  EXPECT_EQ(found.rows, 3u);
}

TEST(Difference, NanIsNeverEqualToAnything) {
  const Difference both = differenceOf({1, kNan}, {1, kNan});
  EXPECT_EQ(both.nan_a, (ValueIndex{1, 0}));
  EXPECT_EQ(both.nan_b, (ValueIndex{1, 0}));
  EXPECT_EQ(both.first, (ValueIndex{1, 0}));
  EXPECT_EQ(both.count, 1u);
  DifferenceMeter meter(1, {});
  meter.add(std::vector<double>{1, kNan}, std::vector<double>{1, 2});
  EXPECT_EQ(meter.firstRowBeyond(1e300), 1u);
  const Difference one = differenceOf({1, 2}, {1, kNan});
  EXPECT_EQ(one.nan_a, std::nullopt);
  EXPECT_EQ(one.nan_b, (ValueIndex{1, 0}));
}

TEST(Difference, MissingOnBothSidesIsTheSameOnlyWhereItMayBeMissing) {
  const Difference both = differenceOf({kNan, 1}, {kNan, 1}, 1, {.may_be_missing = true});
  EXPECT_EQ(both.count, 0u);
  EXPECT_EQ(both.nan_a, std::nullopt);
  const Difference one = differenceOf({kNan, 1}, {0, 1}, 1, {.may_be_missing = true});
  EXPECT_EQ(one.nan_a, (ValueIndex{0, 0}));
  EXPECT_EQ(one.nan_b, std::nullopt);
  EXPECT_EQ(one.count, 1u);
}

TEST(Difference, AnInfinityIsFarFromEveryNumberAndFromTheOther) {
  EXPECT_EQ(differenceOf({kInf}, {kInf}).count, 0u);
  EXPECT_EQ(differenceOf({kInf}, {1e308}).largest, kInf);
  EXPECT_EQ(differenceOf({kInf}, {-kInf}).largest, kInf);
}

TEST(Difference, BitForBitTellsZerosApart) {
  EXPECT_EQ(differenceOf({0.0}, {-0.0}).count, 0u);
  const Difference exact = differenceOf({0.0}, {-0.0}, 1, {.exact = true});
  EXPECT_EQ(exact.count, 1u);
  EXPECT_EQ(exact.largest, 0);
  EXPECT_EQ(exact.worst, (ValueIndex{0, 0}));
  EXPECT_EQ(differenceOf({1.5}, {1.5}, 1, {.exact = true}).count, 0u);
}

// A is B, three rows late, with one value 0.01 off.
TEST(TimeShift, FindsHowLateASeriesIsAndWhatIsLeft) {
  const auto curve = [](double row) { return std::sin(0.1 * row) + 0.001 * row * row; };
  std::vector<double> a, b;
  for (int row = 0; row < 200; ++row) {
    for (const double of_column : {1.0, -2.0}) {
      a.push_back(of_column * curve(row - 3));
      b.push_back(of_column * curve(row));
    }
  }
  a[2 * 100] += 0.01;
  const TimeShift late = bestShift(a, b, same(200), 2, 20);
  EXPECT_EQ(late.rows, 3);
  EXPECT_NEAR(late.remaining, 0.01, 1e-12);
  const TimeShift early = bestShift(b, a, same(200), 2, 20);
  EXPECT_EQ(early.rows, -3);
  EXPECT_EQ(bestShift(a, b, same(200), 2, 2).rows, 2);
}

TEST(TimeShift, OfEqualSeriesAndConstantsIsNone) {
  const std::vector<double> flat(50, 1.0), higher(50, 2.0);
  EXPECT_EQ(bestShift(flat, flat, same(50), 1, 10).rows, 0);
  EXPECT_EQ(bestShift(flat, higher, same(50), 1, 10).rows, 0);
  EXPECT_EQ(bestShift(flat, higher, same(50), 1, 10).remaining, 1);
}

// However far apart, at least half of B keeps a partner: two pulses are not made equal by pushing them out.
TEST(TimeShift, NeverLosesMoreThanHalf) {
  std::vector<double> a(20, 0.0), b(20, 0.0);
  a[0] = 1;
  b[19] = 1;
  const TimeShift found = bestShift(a, b, same(20), 1, 100);
  EXPECT_LE(std::abs(found.rows), 10);
}

// B has every tenth row of A, and is four rows of A early.
TEST(TimeShift, IsCountedInRowsOfA) {
  std::vector<double> a, b;
  std::vector<std::size_t> partners;
  for (int row = 0; row < 300; ++row) a.push_back(std::sin(0.05 * row));
  for (std::size_t row = 0; row < 290; row += 10) {
    partners.push_back(row);
    b.push_back(a[row + 4]);
  }
  const TimeShift found = bestShift(a, b, partners, 1, 9);
  EXPECT_EQ(found.rows, 4);
  EXPECT_EQ(found.remaining, 0);
}

}  // namespace
}  // namespace fissure::difference_test
