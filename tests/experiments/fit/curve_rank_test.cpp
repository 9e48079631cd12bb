#include "fit/curve_rank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fissure::curve_rank_test {

namespace {

using Numbers = std::vector<double>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MeasuredCurve measured() {
  MeasuredCurve curve;
  curve.time_s = {0, 1, 2.5};
  curve.depth_m = {0, 0.001, 0.002};
  curve.force_N = {1, 2, 3};
  curve.weights = {1, 1, 1};
  return curve;
}

TEST(CurveRank, MisfitIsTheRootMeanSquareOfTheDifferences) {
  // Simulated: 0, 2, and 3.5 halfway between 3 and 4: differences 1, 0, -0.5.
  const Misfit misfit = misfitOf(measured(), MatchBy::time, Numbers{0, 1, 2, 3}, Numbers{0, 2, 3, 4}, 0.0);
  EXPECT_NEAR(misfit.rms_N, std::sqrt(1.25 / 3), 1e-15);
  EXPECT_EQ(misfit.F0_N, 0);
  const Misfit shifted =
      misfitOf(measured(), MatchBy::time, Numbers{0, 1, 2, 3}, Numbers{0, 2, 3, 4}, std::nullopt);
  EXPECT_NEAR(shifted.F0_N, 0.5 / 3, 1e-15);
  EXPECT_NEAR(shifted.rms_N, std::sqrt(1.25 / 3 - 0.25 / 9), 1e-15);
  MeasuredCurve weighted = measured();
  weighted.weights = {0.5, 1, 2};
  EXPECT_NEAR(misfitOf(weighted, MatchBy::time, Numbers{0, 1, 2, 3}, Numbers{0, 2, 3, 4}, 0.0).rms_N,
              std::sqrt((0.5 + 2 * 0.25) / 3.5), 1e-15);
}

TEST(CurveRank, DepthsAreMetOnTheWayIn) {
  Numbers way_m = {0, 0, 0.001, 0.0005, 0.002, 0.001}, force_N = {9, 1, 2, 9, 3, 9};
  keepDeepening(way_m, force_N);
  EXPECT_EQ(way_m, (Numbers{0, 0.001, 0.002}));
  EXPECT_EQ(misfitOf(measured(), MatchBy::depth, way_m, force_N, 0.0).rms_N, 0);
  Numbers nothing = {0, 0}, none = {1, 1};
  keepDeepening(nothing, none);
  EXPECT_TRUE(std::isnan(misfitOf(measured(), MatchBy::depth, {}, {}, 0.0).rms_N));
}

TEST(CurveRank, AFixedOffsetIsAddedToTheSimulatedForce) {
  // Differences 1, 0, -0.5 less 0.25.
  const Misfit misfit = misfitOf(measured(), MatchBy::time, Numbers{0, 1, 2, 3}, Numbers{0, 2, 3, 4}, 0.25);
  EXPECT_EQ(misfit.F0_N, 0.25);
  EXPECT_NEAR(misfit.rms_N, std::sqrt((0.75 * 0.75 + 0.25 * 0.25 + 0.75 * 0.75) / 3), 1e-15);
}

TEST(CurveRank, PointsOnAWayBackAreCounted) {
  MeasuredCurve curve = measured();
  EXPECT_EQ(wayBackNote(curve), "");
  curve.time_s = {0, 1, 2, 3, 4};
  curve.depth_m = {0, 0.001, 0.000995, 0.0008, 0.001};  // the third is 5 um shallower, as by noise
  EXPECT_EQ(
      wayBackNote(curve),
      "1 of 5 points are shallower than one before them, as on a way back, and meet the simulated way in: "
      "--match time tells them apart");
  curve.time_s.clear();
  EXPECT_EQ(wayBackNote(curve), "");
}

TEST(CurveRank, RunsThatEndEarlyCannotBeCompared) {
  EXPECT_TRUE(std::isnan(
      misfitOf(measured(), MatchBy::time, Numbers{0, 1, 2}, Numbers{1, 2, 3}, std::nullopt).rms_N));
  EXPECT_TRUE(std::isnan(
      misfitOf(measured(), MatchBy::time, Numbers{0, 1, 2, 3}, Numbers{1, 2, 3, kNaN}, std::nullopt).rms_N));
  EXPECT_TRUE(std::isnan(
      misfitOf(measured(), MatchBy::time, Numbers{0.5, 1, 3}, Numbers{1, 2, 3}, std::nullopt).rms_N));
}

TEST(CurveRank, LeastComesFirstTiesByRunAndNaNLast) {
  std::vector<Misfit> misfits = {{0, 0, kNaN, 0}, {1, 0, 2, 0},    {2, 1, 1, 0},
                                 {2, 0, 1, 0},    {3, 0, kNaN, 0}, {4, 0, 1, 0}};
  rank(misfits);
  const std::vector<std::pair<std::size_t, std::size_t>> expected = {{2, 0}, {2, 1}, {4, 0},
                                                                     {1, 0}, {0, 0}, {3, 0}};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ((std::pair{misfits[i].run, misfits[i].law}), expected[i]) << i;
}

}  // namespace
}  // namespace fissure::curve_rank_test
