#include "fit/law_fit.h"

#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "fit/depth_rates.h"

namespace fissure::law_fit_test {

namespace {

constexpr FitValues kLiver{.coefficients = {.k = 6.08e5, .lambda = 3.04e5, .n = 2.4}, .F0_N = 0.029};

/// Presses of a probe: `points` at even steps of time, a half sine of one depth after the other. Without
/// forces.
MeasuredCurve presses(std::size_t points, const std::vector<double>& depths_m, double duration_s) {
  MeasuredCurve curve;
  for (std::size_t i = 0; i < points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points - 1);
    const double press =
        std::min(share * static_cast<double>(depths_m.size()), static_cast<double>(depths_m.size()) - 1e-9);
    const double angle = std::numbers::pi * (press - std::floor(press));
    curve.time_s.push_back(share * duration_s);
    curve.depth_m.push_back(depths_m[static_cast<std::size_t>(press)] * std::pow(std::sin(angle), 2));
    curve.weights.push_back(1);
  }
  curve.rate_m_s = ratesOf(curve.time_s, curve.depth_m);
  curve.rate_noise_m_s = rateNoiseOf(curve.time_s, curve.depth_m);
  curve.force_N.resize(points);
  return curve;
}

void setForces(const FitValues& law, MeasuredCurve& curve, ForceModel kind = ForceModel::hunt_crossley) {
  makeProbeModel(kind, curve)->evaluate(law, curve.force_N);
  for (double& force_N : curve.force_N) force_N += law.F0_N;
}

LawFit fitted(const MeasuredCurve& curve, const FitSettings& settings,
              ForceModel kind = ForceModel::hunt_crossley) {
  return fitLaw(*makeProbeModel(kind, curve), curve.force_N, curve.weights, settings);
}

MeasuredCurve curveOf(const std::vector<double>& depth_m, const std::vector<double>& force_N) {
  MeasuredCurve curve;
  curve.depth_m = depth_m;
  curve.force_N = force_N;
  curve.weights.assign(depth_m.size(), 1);
  return curve;
}

const FitSettings kAllFree{{}, {true, true, true, true}};
const FitSettings kQuasiStatic{{}, {true, false, true, true}};

TEST(LawFit, FindsTheExactCoefficientsOfALiver) {
  MeasuredCurve curve = presses(60, {0.001, 0.003}, 0.1);
  setForces(kLiver, curve);
  LawFit fit = fitted(curve, kAllFree);
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.law().coefficients.k, kLiver.coefficients.k, 1e-5 * kLiver.coefficients.k);
  EXPECT_NEAR(fit.law().coefficients.lambda, kLiver.coefficients.lambda, 1e-5 * kLiver.coefficients.lambda);
  EXPECT_NEAR(fit.law().coefficients.n, kLiver.coefficients.n, 1e-6);
  EXPECT_NEAR(fit.law().F0_N, kLiver.F0_N, 1e-8);
  EXPECT_NEAR(fit.r_squared, 1, 1e-9);
}

// Every law of the table: what is forgotten in a fit shows here.
TEST(LawFit, FindsTheDefaultsOfEveryLawInTheTable) {
  for (std::size_t i = 0; i < forceLaws().size(); ++i) {
    const auto model = static_cast<ForceModel>(i);
    SCOPED_TRACE(forceLaws()[i].name);
    const FitValues truth{.coefficients = forceLaws()[i].defaults(), .F0_N = -0.01};
    MeasuredCurve curve = presses(60, {0.004, 0.012}, 0.1);
    setForces(truth, curve, model);
    FitSettings settings;
    for (const FitParameter parameter : kFitParameters)
      settings.free[index(parameter)] = hasParameter(model, parameter);
    const LawFit fit = fitted(curve, settings, model);
    EXPECT_TRUE(fit.converged);
    for (const FitParameter parameter : kFitParameters) {
      if (!hasParameter(model, parameter)) continue;
      const double expected = valueOf(model, truth, parameter);
      EXPECT_NEAR(valueOf(model, fit.law(), parameter), expected, 1e-5 * std::abs(expected))
          << nameOf(model, parameter);
      EXPECT_TRUE(fit.of(parameter).free) << nameOf(model, parameter) << fit.of(parameter).problem;
    }
  }
}

TEST(LawFit, OfAStraightLineIsLinearRegression) {
  // By hand: slope 1.99, offset 0.05, residuals 0.06, -0.13, 0.08, -0.01, 0 (depths of metres: only the
  // numbers matter).
  const MeasuredCurve curve = curveOf({1, 2, 3, 4, 5}, {2.1, 3.9, 6.1, 8.0, 10.0});
  const LawFit fit = fitted(curve, {{}, {true, false, false, true}}, ForceModel::linear_elastic);
  EXPECT_NEAR(fit.law().coefficients.k, 1.99, 1e-8);
  EXPECT_NEAR(fit.law().F0_N, 0.05, 1e-7);
  const double s2 = (0.06 * 0.06 + 0.13 * 0.13 + 0.08 * 0.08 + 0.01 * 0.01 + 0) / 3;
  EXPECT_NEAR(fit.rms_N, std::sqrt(s2 * 3 / 5), 1e-9);
  const FittedValue& offset = fit.of(FitParameter::offset);
  EXPECT_NEAR(offset.standard_error, std::sqrt(s2 * (1.0 / 5 + 9.0 / 10)), 1e-6);
  EXPECT_NEAR(offset.high - offset.value, 3.182446 * offset.standard_error, 1e-5);
  EXPECT_FALSE(offset.profiled);
  EXPECT_NEAR(fit.of(FitParameter::elastic).standard_error, std::sqrt(s2 / 10), 1e-6);
}

TEST(LawFit, FindsTheExponentOfTheFirstLiverRegion) {
  // Median forces of probing pig liver, github.com/vu-arma-dev/robot-palpation-data; n of all its data
  // is 2.40.
  const MeasuredCurve curve = curveOf({0.0005, 0.001, 0.0015, 0.002}, {0.039, 0.071, 0.127, 0.235});
  const LawFit fit = fitted(curve, kQuasiStatic);
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.law().coefficients.n, 2.40, 0.3);
  EXPECT_NEAR(fit.law().F0_N, 0.029, 0.01);
  EXPECT_GT(fit.r_squared, 0.997);
}

TEST(LawFit, IntervalsCoverTheTruthAsOftenAsTheySay) {
  MeasuredCurve curve = presses(40, {0.001, 0.002, 0.003}, 0.12);
  setForces(kLiver, curve);
  const std::vector<double> exact_N = curve.force_N;
  boost::random::mt19937_64 random(7);
  boost::random::normal_distribution<double> noise_N(0, 0.01);
  std::array<int, kFitParameters.size()> covered{};
  constexpr int curves = 200;
  for (int i = 0; i < curves; ++i) {
    for (std::size_t p = 0; p < exact_N.size(); ++p) curve.force_N[p] = exact_N[p] + noise_N(random);
    const LawFit fit = fitted(curve, kAllFree);
    ASSERT_TRUE(fit.converged);
    for (std::size_t p = 0; p < kFitParameters.size(); ++p) {
      const double truth = valueOf(ForceModel::hunt_crossley, kLiver, static_cast<FitParameter>(p));
      if (fit.values[p].free && fit.values[p].low <= truth && truth <= fit.values[p].high) ++covered[p];
    }
  }
  for (std::size_t p = 0; p < kFitParameters.size(); ++p) {
    RecordProperty(nameOf(ForceModel::hunt_crossley, static_cast<FitParameter>(p)), covered[p]);
    EXPECT_GE(covered[p], 0.90 * curves) << nameOf(ForceModel::hunt_crossley, static_cast<FitParameter>(p));
    EXPECT_LE(covered[p], 0.99 * curves) << nameOf(ForceModel::hunt_crossley, static_cast<FitParameter>(p));
  }
}

// Bates and Watts: with the rest fitted anew, S has grown by t^2 s^2 at the ends; t(36, 97.5 %) = 2.02809.
TEST(LawFit, ProfiledIntervalsEndWhereTheRestCannotMakeUpForTheChange) {
  MeasuredCurve curve = presses(40, {0.001, 0.002, 0.003}, 0.12);
  setForces(kLiver, curve);
  boost::random::mt19937_64 random(5);
  boost::random::normal_distribution<double> noise_N(0, 0.01);
  for (double& force_N : curve.force_N) force_N += noise_N(random);
  const LawFit fit = fitted(curve, kAllFree);
  const FittedValue& lambda = fit.of(FitParameter::damping);
  ASSERT_TRUE(lambda.profiled);
  const double squares_N2 = 40 * fit.rms_N * fit.rms_N;
  for (const double end : {lambda.low, lambda.high}) {
    const LawFit there = fitted(curve, {{.coefficients = {.lambda = end}}, {true, false, true, true}});
    const double growth_N2 = 40 * there.rms_N * there.rms_N - squares_N2;
    EXPECT_NEAR(std::sqrt(growth_N2 / (squares_N2 / 36)), 2.02809, 0.005);
  }
  // The linear one would say something else.
  EXPECT_GT(std::abs(lambda.high - lambda.value - 2.02809 * lambda.standard_error),
            0.1 * lambda.standard_error);
}

TEST(LawFit, AnExponentBeyondWhatIsSearchedIsFixedAtTheLimit) {
  std::vector<double> depth_m, force_N;
  for (int i = 1; i <= 12; ++i) {
    depth_m.push_back(0.001 * i);
    force_N.push_back(std::pow(i / 12.0, 15));
  }
  const LawFit fit = fitted(curveOf(depth_m, force_N), kQuasiStatic);
  EXPECT_EQ(fit.law().coefficients.n, 8);
  EXPECT_FALSE(fit.of(FitParameter::shape).free);
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_EQ(
      fit.notes[0],
      "n cannot be identified from this data: the least squares lie at a limit of what is searched, 0.2 to "
      "8; it is fixed there");
}

TEST(LawFit, SaysWhenLambdaCannotBeIdentifiedAndStillFindsTheExponent) {
  // 30 s for a press of 3 mm: about 0.3 mm/s at most.
  MeasuredCurve curve = presses(60, {0.003}, 30);
  setForces(kLiver, curve);
  boost::random::mt19937_64 random(3);
  boost::random::normal_distribution<double> noise_N(0, 0.005);
  for (double& force_N : curve.force_N) force_N += noise_N(random);
  const LawFit fit = fitted(curve, kAllFree);
  EXPECT_FALSE(fit.of(FitParameter::damping).free);
  ASSERT_EQ(fit.notes.size(), 1u);
  EXPECT_TRUE(
      fit.notes[0].starts_with("lambda cannot be identified from this data: the 95 % interval of lambda/k, "))
      << fit.notes[0];
  EXPECT_NEAR(fit.law().coefficients.n, 2.4, 0.1);
  EXPECT_LT(fit.of(FitParameter::shape).low, 2.4);
  EXPECT_GT(fit.of(FitParameter::shape).high, 2.4);
}

TEST(LawFit, AShapeThatOverflowsIsRefused) {
  MeasuredCurve curve = presses(60, {0.003}, 0.1);
  setForces({.coefficients = {.k = 0.2, .a = 400}}, curve, ForceModel::exponential);
  try {
    fitted(curve, {{.coefficients = {.a = 1e6}}, {true, false, false, true}}, ForceModel::exponential);
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(
        error.what(),
        std::string("the law's elastic force is no number above 0 at these depths, expected a smaller a"));
  }
}

// A damper's c over k is no time: the message speaks of its force over the elastic one.
TEST(LawFit, JudgesADamperByItsForce) {
  for (const ForceModel model : {ForceModel::kelvin_voigt, ForceModel::exponential}) {
    MeasuredCurve curve = presses(60, {0.003}, 30);
    const double k = model == ForceModel::kelvin_voigt ? 100 : 0.2;  // N/m or N
    setForces({.coefficients = {.k = k, .c = 1, .a = 400}}, curve, model);
    boost::random::mt19937_64 random(3);
    boost::random::normal_distribution<double> noise_N(0, 0.002);
    for (double& force_N : curve.force_N) force_N += noise_N(random);
    const LawFit fit = fitted(curve, {{}, {true, true, model == ForceModel::exponential, true}}, model);
    EXPECT_FALSE(fit.of(FitParameter::damping).free);
    EXPECT_NE(fit.of(FitParameter::damping).problem.find("c over the elastic force at the typical depth"),
              std::string::npos)
        << fit.of(FitParameter::damping).problem;
  }
}

std::string refusal(const std::vector<double>& depth_m, const std::vector<double>& force_N,
                    const FitSettings& settings = kQuasiStatic) {
  try {
    fitted(curveOf(depth_m, force_N), settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(LawFit, RefusesInOneLineWhatCannotBeFitted) {
  EXPECT_EQ(refusal({0.001, 0.002, 0.003}, {1, 2, 3}),
            "3 points for 3 free coefficients, expected more points than these");
  EXPECT_EQ(refusal({0.001, 0.002, 0.003}, {1, 1, 1}),
            "the force is the same everywhere, expected one that changes");
  EXPECT_EQ(refusal({0, 0, 0, 0}, {1, 2, 3, 4}), "all depths are 0, expected some above");
  EXPECT_EQ(refusal({0.001, 0.002, 0.003, 0.004}, {1, NAN, 3, 4}), "a force is no number, expected numbers");
  EXPECT_EQ(refusal({0.001, 0.002, 0.003, 0.004, 0.005}, {5, 4, 3, 2, 1}),
            "the force does not grow with the depth, expected one that does");
  EXPECT_TRUE(refusal({0.001, 0.001, 0.001, 0.001, 0.001}, {1, 2, 3, 4, 5})
                  .starts_with("the data does not determine k, n, F0 (singular value ratio "));
  EXPECT_EQ(
      refusal({0.001, 0.002, 0.003}, {1, 2, 3},
              {{.coefficients = {.k = 1000, .n = 1}}, {false, true, false, false}}),
      "lambda cannot be identified from this data: there is no rate of the depth in it; it is fixed at 0, "
      "and nothing else is free, expected another coefficient to fit");
  EXPECT_EQ(refusal({0.001, 0.002}, {1, 2}, {}), "nothing is free, expected a coefficient to fit");
}

TEST(LawFit, RepeatedPointsAndPointsAtTheSurfaceAreDataLikeAllOthers) {
  const std::vector<double> depth_m = {0, 0.001, 0.001, 0.002, 0.002, 0.003},
                            force_N = {0.02, 0.11, 0.13, 0.40, 0.38, 0.92};
  const LawFit fit = fitted(curveOf(depth_m, force_N), kQuasiStatic);
  EXPECT_NEAR(fit.law().F0_N, 0.02, 0.03);
  EXPECT_NEAR(fit.law().coefficients.n, 2, 0.3);
  // A weight of 2 counts as a point that is there twice.
  MeasuredCurve curve = curveOf({0, 0.001, 0.002, 0.003, 0.004}, {0.02, 0.12, 0.39, 0.92, 1.5});
  const LawFit twice = fitted(
      curveOf({0, 0.001, 0.002, 0.003, 0.003, 0.004}, {0.02, 0.12, 0.39, 0.92, 0.92, 1.5}), kQuasiStatic);
  curve.weights[3] = 2;
  EXPECT_NEAR(fitted(curve, kQuasiStatic).law().coefficients.n, twice.law().coefficients.n, 1e-6);
}

TEST(LawFit, FixedCoefficientsStay) {
  MeasuredCurve curve = presses(40, {0.003}, 0.1);
  setForces(kLiver, curve);
  const LawFit fit = fitted(
      curve, {{.coefficients = {.k = 1, .lambda = kLiver.coefficients.lambda, .n = 2.4}, .F0_N = kLiver.F0_N},
              {true, false, false, false}});
  EXPECT_NEAR(fit.law().coefficients.k, kLiver.coefficients.k, 1e-5 * kLiver.coefficients.k);
  EXPECT_EQ(fit.law().coefficients.n, 2.4);
  EXPECT_FALSE(fit.of(FitParameter::shape).free);
  EXPECT_TRUE(std::isnan(fit.of(FitParameter::shape).low));
}

TEST(LawFit, SaysWhyLambdaCannotBeIdentified) {
  // No rates at all.
  LawFit fit =
      fitted(curveOf({0.0005, 0.001, 0.0015, 0.002, 0.003}, {0.039, 0.071, 0.127, 0.235, 0.6}), kAllFree);
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_EQ(
      fit.notes[0],
      "lambda cannot be identified from this data: there is no rate of the depth in it; it is fixed at 0");
  // One rate: k and lambda do the same.
  MeasuredCurve ramp = curveOf({}, {});
  for (int i = 1; i <= 20; ++i) {
    ramp.time_s.push_back(0.01 * i);
    ramp.depth_m.push_back(0.00015 * i);
    ramp.weights.push_back(1);
  }
  ramp.rate_m_s.assign(20, 0.015);
  ramp.force_N.resize(20);
  setForces(kLiver, ramp);
  ramp.force_N[3] += 0.001;
  fit = fitted(ramp, kAllFree);
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_TRUE(
      fit.notes[0].starts_with("lambda cannot be identified from this data: k and lambda do the same"))
      << fit.notes[0];
  EXPECT_NEAR(fit.law().coefficients.n, 2.4, 0.05);
  EXPECT_NEAR(fit.law().coefficients.k, kLiver.coefficients.k + kLiver.coefficients.lambda * 0.015,
              0.2 * kLiver.coefficients.k);
}

/// The curve as a sensor with noise sees it: its depths, and the rates that come of them.
MeasuredCurve withNoise(MeasuredCurve curve, double depth_noise_m, double force_noise_N, int seed) {
  boost::random::mt19937_64 random(static_cast<unsigned>(seed));
  boost::random::normal_distribution<double> normal(0, 1);
  for (double& depth_m : curve.depth_m) depth_m = std::max(0.0, depth_m + depth_noise_m * normal(random));
  for (double& force_N : curve.force_N) force_N += force_noise_N * normal(random);
  curve.rate_m_s = ratesOf(curve.time_s, curve.depth_m);
  curve.rate_noise_m_s = rateNoiseOf(curve.time_s, curve.depth_m);
  return curve;
}

TEST(LawFit, NoiseOfTheDepthsIsNotTakenForRates) {
  // 1.5 mm/s throughout, at 1 kHz with 10 um of noise: the rates scatter by 7 mm/s.
  MeasuredCurve ramp = curveOf({}, {});
  for (int i = 0; i < 1000; ++i) {
    ramp.time_s.push_back(0.001 * i);
    ramp.depth_m.push_back(0.0015 + 0.0000015 * i);
  }
  ramp.weights.assign(1000, 1);
  ramp.rate_m_s.assign(1000, 0.0015);
  ramp.force_N.resize(1000);
  setForces(kLiver, ramp);
  const LawFit fit = fitted(withNoise(ramp, 1e-5, 0.002, 1), kAllFree);
  EXPECT_FALSE(fit.of(FitParameter::damping).free);
  EXPECT_EQ(fit.law().coefficients.lambda, 0);
  EXPECT_TRUE(fit.of(FitParameter::damping)
                  .problem.starts_with("noise of the depths makes too much of the rates (reliability 0"))
      << fit.of(FitParameter::damping).problem;
  EXPECT_NEAR(fit.law().coefficients.n, 2.4, 0.1);
  const LawFit voigt =
      fitted(withNoise(ramp, 1e-5, 0.002, 1), {{}, {true, true, false, true}}, ForceModel::kelvin_voigt);
  EXPECT_FALSE(voigt.of(FitParameter::damping).free);
}

TEST(LawFit, SmallNoiseOfTheDepthsLeavesTheTruthInTheIntervals) {
  MeasuredCurve curve = presses(240, {0.001, 0.002, 0.003}, 0.24);
  setForces(kLiver, curve);
  for (const int seed : {1, 2, 3}) {
    const LawFit fit = fitted(withNoise(curve, 1e-6, 0.005, seed), kAllFree);
    for (std::size_t p = 0; p < kFitParameters.size(); ++p) {
      const double truth = valueOf(ForceModel::hunt_crossley, kLiver, static_cast<FitParameter>(p));
      EXPECT_TRUE(fit.values[p].free && fit.values[p].low <= truth && truth <= fit.values[p].high)
          << nameOf(ForceModel::hunt_crossley, static_cast<FitParameter>(p)) << " " << seed
          << fit.values[p].problem;
    }
  }
}

TEST(LawFit, SaysWhenLambdaIsNegative) {
  // The force is written 2 ms late: it seems to grow against the rate.
  MeasuredCurve curve = presses(90, {0.001, 0.002, 0.003}, 0.178);
  setForces(kLiver, curve);
  MeasuredCurve late = curve;
  for (std::size_t i = 0; i < 90; ++i) late.force_N[i] = curve.force_N[i < 2 ? 0 : i - 2];
  const LawFit fit = fitted(late, kAllFree);
  EXPECT_LT(fit.law().coefficients.lambda, 0);
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_EQ(fit.notes[0],
            "lambda is negative, which is unphysical: are force and depth recorded at one time?");
}

TEST(LawFit, SaysWhenTheForceHardlyChangesWithTheDepth) {
  const LawFit fit = fitted(
      curveOf({0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.007}, {0.50, 0.52, 0.49, 0.51, 0.50, 0.49, 0.515}),
      kQuasiStatic);
  EXPECT_NE(fit.of(FitParameter::elastic).problem, "");
  EXPECT_NE(fit.of(FitParameter::shape).problem, "");
}

TEST(LawFit, AsksForAConstantForceOnlyWhereItIsAmongTheFits) {
  // Nine depths that hardly differ: F0 + k d would be as good with k = 0, but k d alone is far from it.
  const MeasuredCurve curve =
      curveOf({0.0028, 0.00285, 0.0029, 0.00295, 0.003, 0.00305, 0.0031, 0.00315, 0.0032},
              {0.284, 0.281, 0.309, 0.295, 0.290, 0.301, 0.306, 0.289, 0.298});
  const LawFit fixed = fitted(curve, {{}, {true, false, false, false}}, ForceModel::linear_elastic);
  EXPECT_EQ(fixed.of(FitParameter::elastic).problem, "");
  EXPECT_NEAR(fixed.law().coefficients.k, 98, 3);
  const LawFit free = fitted(curve, {{}, {true, false, false, true}}, ForceModel::linear_elastic);
  EXPECT_NE(free.of(FitParameter::elastic).problem, "");
}

TEST(LawFit, SaysWhenResidualsAreAlikeByMoreThanChance) {
  MeasuredCurve curve = presses(100, {0.003}, 1);
  setForces(kLiver, curve);
  const MeasuredCurve exact = curve;
  boost::random::mt19937_64 random(1);
  boost::random::normal_distribution<double> noise_N(0, 0.01);
  // Each with 0.45 of the one before: above 0.233, which independent ones exceed once in a hundred times.
  double alike_N = 0;
  for (double& force_N : curve.force_N) force_N += alike_N = 0.45 * alike_N + noise_N(random);
  LawFit fit = fitted(curve, kQuasiStatic);
  ASSERT_EQ(fit.notes.size(), 1u) << fit.next_correlation;
  EXPECT_LT(fit.next_correlation, 0.5);
  EXPECT_TRUE(fit.notes[0].starts_with("residuals of neighbouring points are alike")) << fit.notes[0];
  curve = exact;
  for (double& force_N : curve.force_N) force_N += noise_N(random);
  fit = fitted(curve, kQuasiStatic);
  EXPECT_TRUE(fit.notes.empty()) << fit.next_correlation;
}

TEST(LawFit, SaysWhenResidualsAreNoNoise) {
  MeasuredCurve curve = presses(100, {0.003}, 1);
  setForces(kLiver, curve);
  for (std::size_t i = 0; i < 100; ++i) curve.force_N[i] += 0.02 * std::sin(0.2 * static_cast<double>(i));
  const LawFit fit = fitted(curve, kQuasiStatic);
  ASSERT_EQ(fit.notes.size(), 1u);
  EXPECT_TRUE(fit.notes[0].starts_with("residuals of neighbouring points are alike")) << fit.notes[0];
}

}  // namespace
}  // namespace fissure::law_fit_test
