#include "study/tradeoff_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace fissure::tradeoff_curve_test {

namespace {

StudyCurve sampled(double step_s, double until_s, const std::function<double(double)>& value) {
  StudyCurve curve;
  for (int i = 0; i * step_s <= until_s + 1e-9; ++i) {
    curve.time_s.push_back(i * step_s);
    curve.values.push_back(value(i * step_s));
  }
  return curve;
}

}  // namespace

TEST(StudyCurve, ConstantOffsetIsItsRmsWorstAndPeak) {
  const StudyCurve reference = sampled(0.01, 1, [](double t) { return t; });
  const StudyCurve run = sampled(0.01, 1, [](double t) { return t + 0.25; });
  const CurveError error = errorOf(run, reference);
  EXPECT_NEAR(error.rms, 0.25, 1e-12);
  EXPECT_NEAR(error.worst, 0.25, 1e-12);
  EXPECT_NEAR(error.peak, 0.25, 1e-12);
}

TEST(StudyCurve, ASineOfAnotherPhaseHasTheSamePeakAndAKnownRms) {
  // sin(w t) - sin(w t + a) = -2 sin(a / 2) cos(w t + a / 2): over whole periods its RMS is sqrt(2) sin(a /
  // 2).
  const double w = 2 * std::numbers::pi, a = 0.3;
  const StudyCurve reference = sampled(1e-3, 2 - 1e-3, [&](double t) { return std::sin(w * t); });
  const StudyCurve run = sampled(1e-3, 2 - 1e-3, [&](double t) { return std::sin(w * t + a); });
  const CurveError error = errorOf(run, reference);
  EXPECT_NEAR(error.rms, std::numbers::sqrt2 * std::sin(a / 2), 1e-9);
  EXPECT_NEAR(error.worst, 2 * std::sin(a / 2), 1e-5);
  EXPECT_NEAR(error.peak, 0, 1e-5);
}

TEST(StudyCurve, OtherStepsAreComparedAtCommonTimes) {
  const auto line = [](double t) { return 3 * t + 1; };
  for (const double step_s : {0.004, 0.007, 0.0125})
    EXPECT_NEAR(errorOf(sampled(step_s, 1, line), sampled(0.001, 1, line)).worst, 0, 1e-12) << step_s;
  // A parabola between points h apart is at most h^2 / 8 of its second derivative off.
  const auto parabola = [](double t) { return t * t; };
  const CurveError error = errorOf(sampled(0.004, 1, parabola), sampled(0.0099, 1, parabola));
  EXPECT_LT(error.worst, 0.004 * 0.004 / 4 * 1.001);
  EXPECT_GT(error.worst, 0);
}

TEST(StudyCurve, AnythingMissingIsNoError) {
  const auto line = [](double t) { return t; };
  const StudyCurve reference = sampled(0.01, 1, line);
  EXPECT_TRUE(std::isnan(errorOf({}, reference).rms));
  EXPECT_TRUE(std::isnan(errorOf(reference, {}).rms));
  StudyCurve gap = reference;
  gap.values[40] = std::nan("");
  EXPECT_TRUE(std::isnan(errorOf(gap, reference).rms));
  EXPECT_TRUE(std::isnan(errorOf(reference, gap).worst));
  gap.values[40] = INFINITY;
  EXPECT_TRUE(std::isnan(errorOf(gap, reference).peak));
  EXPECT_TRUE(std::isnan(errorOf(sampled(0.01, 0.5, line), reference).rms)) << "it stopped half way";
  EXPECT_FALSE(std::isnan(errorOf(sampled(0.03, 1, line), reference).rms)) << "its last step ends at 0.99 s";
}

TEST(StudyCurve, PeakIsOfMagnitudes) {
  EXPECT_EQ((StudyCurve{{0, 1, 2}, {1, -4, 2}}).peak(), 4);
  EXPECT_TRUE(std::isnan((StudyCurve{{0, 1}, {1, std::nan("")}}).peak()));
  EXPECT_TRUE(std::isnan(StudyCurve().peak()));
}

}  // namespace fissure::tradeoff_curve_test
