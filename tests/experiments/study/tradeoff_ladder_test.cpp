#include "study/tradeoff_ladder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fissure::tradeoff_ladder_test {

namespace {

/// |f(h_i) - f(h_i+1)| of f(h) = 1 + c h^p.
std::vector<double> differencesOf(const std::vector<double>& sizes, double c, double p) {
  std::vector<double> differences;
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
    differences.push_back(std::abs(c * (std::pow(sizes[i], p) - std::pow(sizes[i + 1], p))));
  return differences;
}

}  // namespace

TEST(TradeoffLadder, FindsTheOrderOfPowersForAnySizes) {
  for (const std::vector<double>& sizes :
       std::vector<std::vector<double>>{{0.004, 0.002, 0.001}, {1, 0.5, 0.2}, {8, 4, 3, 1}})
    for (const double p : {0.6, 1.0, 2.0, 3.0, -1.0})
      EXPECT_NEAR(observedOrder(sizes, differencesOf(sizes, 0.3, p)), p, 1e-9) << p;
}

TEST(TradeoffLadder, ItsErrorIsTheTrueOneTimesTheFactorOfSafety) {
  const std::vector<double> sizes{0.004, 0.002, 0.001};
  for (const double p : {1.0, 1.5, 2.0}) {
    const Refinement found = refinementOf(sizes, differencesOf(sizes, 5, p), 0, "N");
    EXPECT_EQ(found.refused, "");
    EXPECT_NEAR(found.error, ladder_safety * 5 * std::pow(0.001, p), 1e-9 * found.error + 1e-15) << p;
  }
  // An order above two is not relied on: the error is not below that of order two.
  const std::vector<double> steep = differencesOf(sizes, 5, 4);
  EXPECT_NEAR(refinementOf(sizes, steep, 0, "N").error, ladder_safety * steep[1] / 3, 1e-18);
}

TEST(TradeoffLadder, RichardsonFindsTheLimit) {
  const auto f = [](double h) { return 7 - 3 * std::pow(h, 1.3); };
  EXPECT_NEAR(richardson(f(0.2), f(0.1), 0.2, 0.1, 1.3), 7, 1e-12);
}

TEST(TradeoffLadder, RefusesWhatDoesNotConverge) {
  const std::vector<double> sizes{0.004, 0.002, 0.001};
  // A shell's reaction grows as 1 / dt^2: order -2.
  const Refinement shell = refinementOf(sizes, differencesOf(sizes, 1e-6, -2), 0, "N");
  EXPECT_NE(shell.refused.find("does not converge"), std::string::npos);
  EXPECT_NE(shell.refused.find("order -2.00"), std::string::npos) << shell.refused;
  EXPECT_TRUE(std::isnan(shell.error));
  EXPECT_NE(refinementOf(sizes, std::vector<double>{0.1, 0.1}, 0, "m").refused, "");
  EXPECT_NE(refinementOf(sizes, std::vector<double>{0.1, 0.09}, 0, "m").refused, "") << "order 0.15";
  EXPECT_NE(refinementOf(sizes, std::vector<double>{0.1, std::nan("")}, 0, "m").refused, "");
  EXPECT_NE(refinementOf(sizes, std::vector<double>{std::nan(""), 0.1}, 0, "m").refused, "");
  EXPECT_NE(refinementOf(sizes, std::vector<double>{0, 0.1}, 0, "m").refused, "");
}

TEST(TradeoffLadder, EqualRungsAreAReferenceWithoutAnOrder) {
  const std::vector<double> sizes{4, 2, 1};
  const Refinement same = refinementOf(sizes, std::vector<double>{1e-9, 2e-9}, 1e-7, "m");
  EXPECT_EQ(same.refused, "");
  EXPECT_TRUE(std::isnan(same.order));
  EXPECT_EQ(same.error, 2e-9);
  EXPECT_EQ(refinementOf(sizes, std::vector<double>{0, 0}, 0, "m").error, 0);
  EXPECT_EQ(refinementOf(sizes, std::vector<double>{0.1, 0}, 0, "m").error, 0);
}

}  // namespace fissure::tradeoff_ladder_test
