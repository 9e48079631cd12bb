#include "study/stability_boundary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fissure {
namespace {

constexpr auto kStable = StabilityClass::stable;
constexpr auto kDeep = StabilityClass::penetrating;

TEST(StabilityBoundary, LiesBetweenNeighboursOfDifferentClasses) {
  const auto found =
      boundariesOf({{{"a"}, 8, kDeep}, {{"a"}, 1, kStable}, {{"a"}, 4, kStable}, {{"b"}, 2, kDeep}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].others, std::vector<std::string>{"a"});
  EXPECT_EQ(found[0].below, 4);
  EXPECT_EQ(found[0].above, 8);
  EXPECT_EQ(found[0].class_below, kStable);
  EXPECT_EQ(found[0].class_above, kDeep);
  EXPECT_TRUE(boundariesOf({}).empty());
  EXPECT_TRUE(boundariesOf({{{}, 1, kDeep}, {{}, 2, kDeep}}).empty());
}

TEST(StabilityBoundary, HalvingByFactorsFindsAThreshold) {
  for (const double threshold : {1.3e-6, 4.7e-3, 0.09}) {
    std::vector<ClassedPoint> points = {{{}, 1e-6, kStable}, {{}, 0.1, kDeep}};
    int runs = 0;
    for (std::vector<StabilityBoundary> found = boundariesOf(points);; found = boundariesOf(points)) {
      ASSERT_EQ(found.size(), 1u);
      const auto next = nextPlace(found[0], 0.05, false);
      if (!next) {
        EXPECT_LE(found[0].below, threshold);
        EXPECT_GT(found[0].above, threshold);
        EXPECT_LE(found[0].above / found[0].below, 1.053);
        break;
      }
      points.push_back({{}, *next, *next <= threshold ? kStable : kDeep});
      ASSERT_LT(++runs, 12);  // log2(ln(1e5) / ln(1.05)) = 7.9
    }
  }
}

TEST(StabilityBoundary, PlacesThatAreNotAboveZeroAreHalvedByDifferences) {
  EXPECT_EQ(nextPlace({{}, 0, 8, kStable, kDeep}, 0.05, false), 4);
  EXPECT_EQ(nextPlace({{}, -8, -2, kStable, kDeep}, 0.05, false), -5);
  EXPECT_FALSE(nextPlace({{}, 1, 1.05, kStable, kDeep}, 0.05, false));
  EXPECT_FALSE(nextPlace({{}, 1, std::nan(""), kStable, kDeep}, 0.05, false));
}

TEST(StabilityBoundary, WholeNumbersAreHalvedToWholeNumbers) {
  EXPECT_EQ(nextPlace({{}, 1, 8, kStable, kDeep}, 0.05, true), 3);
  EXPECT_EQ(nextPlace({{}, 0, 3, kStable, kDeep}, 0.05, true), 2);
  EXPECT_FALSE(nextPlace({{}, 2, 3, kStable, kDeep}, 0.05, true));
}

}  // namespace
}  // namespace fissure
