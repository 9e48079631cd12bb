#include "compare/expectations.h"

#include <gtest/gtest.h>

#include <limits>

namespace fissure::expectations_test {

namespace {

PipelineResult runWith(const std::string& name, const Summary& summary, RunEnd end = RunEnd::ok) {
  return {.name = name, .status = {end, ""}, .summary = summary};
}

bool holds(const Expectation& expected, double found) {
  const auto all = checkExpectations({expected}, {runWith("fukuhara", {{expected.quantity, found}})});
  EXPECT_EQ(all.size(), 1u);
  return all.front().holds;
}

TEST(Expectations, BoundsAndTolerancesAreIncluded) {
  const Expectation at_most{.quantity = "depth_m", .max = 0.5};
  EXPECT_TRUE(holds(at_most, 0.5));
  EXPECT_FALSE(holds(at_most, 0.5000001));
  const Expectation at_least{.quantity = "depth_m", .min = 0.5};
  EXPECT_TRUE(holds(at_least, 0.5));
  EXPECT_FALSE(holds(at_least, 0.4999999));
  const Expectation value{.quantity = "depth_m", .value = 2, .tolerance = 0.25};
  EXPECT_TRUE(holds(value, 1.75));
  EXPECT_TRUE(holds(value, 2.25));
  EXPECT_FALSE(holds(value, 2.26));
  const Expectation both{.quantity = "depth_m", .value = 2, .tolerance = 1, .max = 2.5};
  EXPECT_FALSE(holds(both, 2.75));
}

TEST(Expectations, NanHoldsNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(holds({.quantity = "depth_m", .max = 1}, nan));
  EXPECT_FALSE(holds({.quantity = "depth_m", .min = 1}, nan));
  EXPECT_FALSE(holds({.quantity = "depth_m", .value = 1, .tolerance = 1e300}, nan));
}

TEST(Expectations, WhatIsMissingDoesNotHoldAndIsNamed) {
  const Expectation expected{.pipeline = "fukuhara", .quantity = "max_penetration_depth", .max = 1};
  const auto misspelt =
      checkExpectations({expected}, {runWith("fukuhara", {{"max_penetration_depth_m", 0.0}})});
  EXPECT_FALSE(misspelt.front().holds);
  EXPECT_EQ(
      expectationText(misspelt.front()),
      "fukuhara: max_penetration_depth is not in the summary, did you mean \"max_penetration_depth_m\"?, "
      "expected at most 1");
  EXPECT_FALSE(checkExpectations({expected}, {}).front().holds);
  const Expectation text{.quantity = "final_state_hash", .min = 0};
  EXPECT_FALSE(
      checkExpectations({text}, {runWith("a", {{"final_state_hash", std::string("1")}})}).front().holds);
}

TEST(Expectations, OfARunThatFailedDoNotHold) {
  const Expectation expected{.quantity = "depth_m", .max = 1};
  const auto checked = checkExpectations({expected}, {runWith("a", {{"depth_m", 0.0}}, RunEnd::non_finite)});
  EXPECT_FALSE(checked.front().holds);
  EXPECT_EQ(checked.front().found, "unknown, the run is non_finite");
}

// A tool that touched nothing proves nothing by its small depth.
TEST(Expectations, UpperBoundsOnDepthNeedContact) {
  const Summary missed = {{"max_penetration_depth_m", 0.0},
                          {"passed_through_samples", 0LL},
                          {"max_inverted_triangles", 0LL},
                          {"steps", 3LL},
                          {"untouched_tools", std::string("left, right")}};
  const auto holdsHere = [&](const Expectation& expected) {
    return checkExpectations({expected}, {runWith("a", missed)}).front().holds;
  };
  for (const char* quantity :
       {"max_penetration_depth_m", "passed_through_samples", "max_inverted_triangles"}) {
    EXPECT_FALSE(holdsHere({.quantity = quantity, .max = 1}));
    EXPECT_FALSE(holdsHere({.quantity = quantity, .value = 0, .tolerance = 0}));
    EXPECT_TRUE(holdsHere({.quantity = quantity, .min = 0}));
    EXPECT_TRUE(holdsHere({.quantity = quantity, .max = 1, .contact = ExpectedContact::any}));
  }
  EXPECT_TRUE(holdsHere({.quantity = "steps", .max = 3}));
  const auto checked =
      checkExpectations({{.quantity = "passed_through_samples", .max = 0}}, {runWith("a", missed)});
  EXPECT_EQ(
      expectationText(checked.front()),
      "a: passed_through_samples is 0, but left, right never touched tissue (contact: any lets that pass), "
      "expected at most 0");
}

TEST(Expectations, WithoutAPipelineAreAboutEveryRun) {
  const Expectation expected{.quantity = "steps", .value = 3, .tolerance = 0};
  const auto checked =
      checkExpectations({expected}, {runWith("a", {{"steps", 3LL}}), runWith("b", {{"steps", 4LL}})});
  ASSERT_EQ(checked.size(), 2u);
  EXPECT_TRUE(checked[0].holds);
  EXPECT_FALSE(checked[1].holds);
}

}  // namespace
}  // namespace fissure::expectations_test
