#include "study/tradeoff_choice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fissure::tradeoff_choice_test {

namespace {
const double kNaN = std::nan("");
using Numbers = std::vector<double>;
}  // namespace

TEST(TradeoffChoice, FrontHasWhatNothingBeats) {
  const Numbers costs{1, 2, 3, 3, 4, 2}, errors{8, 4, 5, 1, 1, 4};
  EXPECT_EQ(paretoFront(costs, errors), (std::vector<bool>{true, true, false, true, false, true}));
}

// Each is within a percent of the next cheaper one, and the cheapest is 3.6 % worse than the first.
TEST(TradeoffChoice, SmallDifferencesDoNotAddUp) {
  const Numbers costs{5, 4, 3, 2, 1}, errors{1, 1.009, 1.018, 1.027, 1.036};
  EXPECT_EQ(paretoFront(costs, errors), (std::vector<bool>{true, false, true, false, true}));
}

TEST(TradeoffChoice, WhatIsMissingIsNeverOnTheFrontNorBeatsAnything) {
  const Numbers costs{kNaN, 1, 5, INFINITY}, errors{0, kNaN, 2, 0};
  EXPECT_EQ(paretoFront(costs, errors), (std::vector<bool>{false, false, true, false}));
}

TEST(TradeoffChoice, OrderOfPowersAboveTheFloor) {
  const Numbers sizes{1, 2, 4, 8};
  Numbers errors;
  for (const double h : sizes) errors.push_back(0.1 * std::pow(h, 1.7));
  EXPECT_NEAR(orderOf(sizes, errors, 0).order, 1.7, 1e-12);
  EXPECT_EQ(orderOf(sizes, errors, 0.1).values, 3u) << "0.1 is below twice the reference's own error";
  EXPECT_NEAR(orderOf(sizes, errors, 0.1).order, 1.7, 1e-12);
  EXPECT_TRUE(std::isnan(orderOf(sizes, errors, 0.2).order));
  errors[1] = kNaN;
  EXPECT_NEAR(orderOf(sizes, errors, 0).order, 1.7, 1e-12);
  errors[2] = 0;
  EXPECT_TRUE(std::isnan(orderOf(sizes, errors, 0).order)) << "two values are no order";
}

TEST(TradeoffChoice, ErrorsWithinAPercentAreTheSameAndTheCheaperIsTaken) {
  const Numbers costs{100, 200, 300}, errors{1.005, 1, 0.9};
  EXPECT_EQ(paretoFront(costs, errors), (std::vector<bool>{true, false, true}));
  EXPECT_EQ(mostAccurate(costs, errors, 250).best, 0u);
  EXPECT_EQ(mostAccurate(costs, errors, 300).best, 2u);
}

TEST(TradeoffChoice, MostAccurateWithinABudget) {
  const Numbers costs{100, 400, 900, 2000, 300}, errors{5, 3, 1, 0.1, kNaN};
  EXPECT_EQ(mostAccurate(costs, errors, 1000).best, 2u);
  EXPECT_EQ(mostAccurate(costs, errors, 400).best, 1u);
  const Choice none = mostAccurate(costs, errors, 50);
  EXPECT_FALSE(none.best);
  EXPECT_EQ(none.nearest, 0u);
  EXPECT_DOUBLE_EQ(none.times_over, 2);
}

TEST(TradeoffChoice, CheapestWithinErrors) {
  const Numbers costs{100, 400, 900, 50, kNaN}, excess{5, 0.9, 0.1, kNaN, 0};
  EXPECT_EQ(cheapest(costs, excess).best, 1u);
  const Choice none = cheapest(costs, Numbers{5, 2, 3, kNaN, 0});
  EXPECT_FALSE(none.best);
  EXPECT_EQ(none.nearest, 1u);
  EXPECT_DOUBLE_EQ(none.times_over, 2);
  EXPECT_FALSE(cheapest(costs, Numbers(5, kNaN)).nearest);
}

TEST(TradeoffChoice, SpreadIsMedianAndQuartilesOfWhatIsThere) {
  const Spread spread = spreadOf({5, 1, kNaN, 3, 2, 4});
  EXPECT_EQ(spread.low, 2);
  EXPECT_EQ(spread.median, 3);
  EXPECT_EQ(spread.high, 4);
  EXPECT_EQ(spread.count, 5u);
  EXPECT_EQ(spreadOf({7}).high, 7);
  EXPECT_TRUE(std::isnan(spreadOf({kNaN}).median));
}

}  // namespace fissure::tradeoff_choice_test
