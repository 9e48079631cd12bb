#include "fit/simulated_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "fit/depth_rates.h"
#include "fit/law_fit.h"

namespace fissure::simulated_model_test {

namespace {

constexpr int kTriangles = 3;
constexpr std::size_t kSteps = 101;

/// A simulation of 0.1 s whose three triangles, the second twice as deep, go in by a squared sine of 2 mm and
/// come out again, all along x; contact begins with step 10. The way of the tool is the first one's depth.
SimulatedRun press() {
  SimulatedRun run;
  run.laws = {{.name = "linear", .model = ForceModel::linear_elastic},
              {.name = "hc", .model = ForceModel::hunt_crossley}};
  run.inputs.laws = {"linear", "hc"};
  for (std::size_t step = 0; step < kSteps; ++step) {
    const double time_s = 0.001 * static_cast<double>(step);
    const double angle = std::numbers::pi * (time_s - 0.01) / 0.09;
    const bool contact = step >= 10;
    const double depth_m = contact ? 0.002 * std::pow(std::sin(angle), 2) : 0;
    const double rate_m_s = 0.002 * std::sin(2 * angle) * std::numbers::pi / 0.09;
    run.inputs.times_s.push_back(time_s);
    run.inputs.row_sizes.push_back(contact ? kTriangles : 0);
    run.way_m.push_back(depth_m);
    for (int i = 0; contact && i < kTriangles; ++i)
      for (int law = 0; law < 2; ++law)
        run.inputs.inputs.push_back(
            {(i == 1 ? 2 : 1) * depth_m, (i == 1 ? 2 : 1) * rate_m_s, 1e-5, Vec3::UnitX()});
  }
  return run;
}

/// The closed form of what Hunt-Crossley triangles of press() give at a depth of the first.
double force_N(const FitValues& law, double depth_m, double rate_m_s) {
  double sum_N = 0;
  for (const double factor : {1.0, 2.0, 1.0})
    sum_N += (law.coefficients.k + law.coefficients.lambda * factor * rate_m_s) *
             std::pow(factor * depth_m, law.coefficients.n);
  return sum_N;
}

/// Measured at each step from the third in contact on.
MeasuredCurve measured(const SimulatedRun& run, const FitValues& law) {
  MeasuredCurve curve;
  curve.name = "probe";
  for (std::size_t step = 12; step < kSteps; ++step) {
    const double angle = std::numbers::pi * (run.inputs.times_s[step] - 0.01) / 0.09;
    const double rate_m_s = 0.002 * std::sin(2 * angle) * std::numbers::pi / 0.09;
    curve.time_s.push_back(run.inputs.times_s[step]);
    curve.depth_m.push_back(run.way_m[step]);
    curve.force_N.push_back(law.F0_N + force_N(law, run.way_m[step], rate_m_s));
    curve.weights.push_back(1);
  }
  return curve;
}

constexpr FitValues kLaw{.coefficients = {.k = 5e4, .lambda = 2e4, .n = 1.8}, .F0_N = 0.05};
const FitSettings kAllFree{{}, {true, true, true, true}};

TEST(SimulatedModel, FitsTheLawOfTheTrianglesToForcesOverTime) {
  const SimulatedRun run = press();
  const SimulatedFit made =
      makeSimulatedFit(ForceModel::hunt_crossley, run, measured(run, kLaw), MatchBy::time);
  const LawFit fit = fitLaw(*made.model, made.curve.force_N, made.curve.weights, kAllFree);
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.law().coefficients.k, kLaw.coefficients.k, 1e-4 * kLaw.coefficients.k);
  EXPECT_NEAR(fit.law().coefficients.lambda, kLaw.coefficients.lambda, 1e-4 * kLaw.coefficients.lambda);
  EXPECT_NEAR(fit.law().coefficients.n, kLaw.coefficients.n, 1e-5);
  EXPECT_NEAR(fit.law().F0_N, kLaw.F0_N, 1e-7);
  EXPECT_TRUE(made.curve.warnings.empty());
}

TEST(SimulatedModel, MeetsMeasuredDepthsOnTheWayIn) {
  const SimulatedRun run = press();
  MeasuredCurve curve = measured(run, kLaw);
  curve.depth_m[3] = 0.003;  // deeper than the simulation gets
  const SimulatedFit made = makeSimulatedFit(ForceModel::hunt_crossley, run, curve, MatchBy::depth);
  ASSERT_EQ(made.curve.force_N.size(), curve.force_N.size() - 1);
  ASSERT_EQ(made.curve.warnings.size(), 2u);
  EXPECT_EQ(made.curve.warnings[0], "left out 1 of 89 points that the simulation does not reach");
  EXPECT_TRUE(made.curve.warnings[1].starts_with("43 of 88 points are shallower than one before them"))
      << made.curve.warnings[1];
  std::vector<double> forces_N(made.model->size());
  made.model->evaluate({.coefficients = kLaw.coefficients}, forces_N);
  // The last point is on the way out, at a depth of nearly 0; the way in has a rate above 0 there.
  EXPECT_NEAR(forces_N[20], made.curve.force_N[20] - kLaw.F0_N, 1e-9);
  const std::size_t out = 70;
  const double depth_m = made.curve.depth_m[out];
  const double rate_m_s = 2 * std::sqrt(depth_m * (0.002 - depth_m)) * std::numbers::pi / 0.09;
  EXPECT_NEAR(forces_N[out], force_N(kLaw, depth_m, rate_m_s), 1e-2 * forces_N[out]);
}

TEST(SimulatedModel, DepthsWithoutRatesSayNothingOfLambda) {
  const SimulatedRun run = press();
  MeasuredCurve curve = measured(run, kLaw);
  curve.time_s.clear();
  const SimulatedFit made = makeSimulatedFit(ForceModel::hunt_crossley, run, curve, MatchBy::depth);
  const LawFit fit = fitLaw(*made.model, made.curve.force_N, made.curve.weights, kAllFree);
  EXPECT_EQ(fit.of(FitParameter::damping).problem, "there is no rate of the depth in it; it is fixed at 0");
  EXPECT_EQ(made.rate_note, "");
  curve = measured(run, kLaw);
  EXPECT_GT(makeSimulatedFit(ForceModel::hunt_crossley, run, curve, MatchBy::time).model->rateScale_m_s(), 0);
}

TEST(SimulatedModel, SaysWhereMeasuredAndSimulatedRatesDiffer) {
  const SimulatedRun run = press();
  MeasuredCurve curve = measured(run, kLaw);
  const auto note = [&](double slower, double noise_m_s) {
    MeasuredCurve slow = curve;
    for (double& time_s : slow.time_s) time_s *= slower;
    slow.rate_m_s = ratesOf(slow.time_s, slow.depth_m);
    slow.rate_noise_m_s.assign(slow.rate_m_s.size(), noise_m_s);
    return makeSimulatedFit(ForceModel::hunt_crossley, run, slow, MatchBy::depth).rate_note;
  };
  EXPECT_EQ(note(1, 0), "");
  EXPECT_EQ(note(1.8, 0), "");
  EXPECT_TRUE(note(20, 0).starts_with("typical rates are 0.002")) << note(20, 0);
  EXPECT_NE(note(0.3, 0), "");
  EXPECT_TRUE(note(1, 0.1).starts_with("typical rates are 0 m/s in the curve and 0.0")) << note(1, 0.1);
}

TEST(SimulatedModel, InterpolatesBetweenSteps) {
  const SimulatedRun run = press();
  MeasuredCurve curve = measured(run, kLaw);
  curve.time_s = {0.0305};
  curve.force_N = curve.weights = {1};
  std::vector<double> forces_N(1);
  makeSimulatedFit(ForceModel::linear_elastic, run, curve, MatchBy::time)
      .model->evaluate({.coefficients = {.k = 2}}, forces_N);
  EXPECT_NEAR(forces_N[0], 2 * 4 * (run.way_m[30] + run.way_m[31]) / 2, 1e-15);
}

// Also of laws that the scenario does not have: they see the triangles as its first one does.
TEST(SimulatedModel, SumsEveryLawOfTheTable) {
  const SimulatedRun run = press();
  const MeasuredCurve curve = measured(run, kLaw);
  for (std::size_t i = 0; i < forceLaws().size(); ++i) {
    const auto model = static_cast<ForceModel>(i);
    const LawCoefficients coefficients = forceLaws()[i].defaults();
    const ForceLaw law(model, coefficients);
    std::vector<double> forces_N(curve.force_N.size());
    makeSimulatedFit(model, run, curve, MatchBy::time).model->evaluate({coefficients, 0}, forces_N);
    std::size_t input = 0;
    for (std::size_t step = 0; step < kSteps; ++step) {
      Vec3 sum_N = Vec3::Zero();
      for (std::size_t t = 0; t < run.inputs.row_sizes[step]; ++t, input += 2) {
        const LawForce force =
            law.at(run.inputs.inputs[input].deformation_m, run.inputs.inputs[input].rate_m_s);
        sum_N += (force.elastic_N + force.viscous_N) * run.inputs.inputs[input].direction;
      }
      for (std::size_t p = 0; p < forces_N.size(); ++p) {
        if (std::abs(curve.time_s[p] - run.inputs.times_s[step]) > 1e-9) continue;
        EXPECT_NEAR(forces_N[p], sum_N.norm(), 1e-9 * (1 + sum_N.norm()))
            << forceLaws()[i].name << " " << step;
      }
    }
  }
}

TEST(SimulatedModel, TakesNegativeLambdasToo) {
  const SimulatedRun run = press();
  const FitValues law{.coefficients = {.k = 5e4, .lambda = -2e4, .n = 1.8}};
  const MeasuredCurve curve = measured(run, law);
  std::vector<double> forces_N(curve.force_N.size());
  makeSimulatedFit(ForceModel::hunt_crossley, run, curve, MatchBy::time).model->evaluate(law, forces_N);
  for (std::size_t i = 0; i < forces_N.size(); ++i) EXPECT_NEAR(forces_N[i], curve.force_N[i], 1e-12);
}

TEST(SimulatedModel, RefusesWhatDoesNotMeet) {
  const SimulatedRun run = press();
  MeasuredCurve curve = measured(run, kLaw);
  const auto refusal = [&](MatchBy by, const SimulatedRun& in) -> std::string {
    try {
      makeSimulatedFit(ForceModel::hunt_crossley, in, curve, by);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  curve.depth_m.clear();
  EXPECT_EQ(refusal(MatchBy::depth, run), "the curve has no depths, expected a column of them");
  for (double& time_s : curve.time_s) time_s += 1;
  EXPECT_EQ(refusal(MatchBy::time, run), "the simulation reaches none of its times: it has 0 to 0.1 s");
  curve.depth_m.assign(curve.force_N.size(), 0.001);
  SimulatedRun apart = run;
  apart.inputs.row_sizes.assign(kSteps, 0);
  apart.inputs.inputs.clear();
  EXPECT_EQ(refusal(MatchBy::depth, apart), "the simulation reaches none of its depths: it meets no tissue");
  curve.time_s.assign(curve.force_N.size(), 0.005);
  EXPECT_EQ(refusal(MatchBy::time, run),
            "the simulation deforms no tissue where the curve is, expected one that does");
}

TEST(WaySinceContact, BeginsWhereTheToolWasThoughThatStepHasNoRow) {
  ForceInputs inputs;
  std::vector<Vec3> tool_m;
  for (int row = 0; row < 6; ++row) {
    inputs.times_s.push_back(0.01 * row);
    inputs.row_sizes.push_back(row >= 3 ? 2 : 0);
    tool_m.emplace_back(0, -0.001 * row, 0);
  }
  const auto way_m = [&](double contact_s) { return waySinceContact(tool_m, inputs, contact_s); };
  const std::vector<double> between = way_m(0.024);
  EXPECT_EQ(between[2], 0);
  EXPECT_NEAR(between[3], 0.0006, 1e-15);
  EXPECT_NEAR(between[5], 0.0026, 1e-15);
  for (const double at_a_row_s : {0.03, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(way_m(at_a_row_s)[3], 0);
    EXPECT_NEAR(way_m(at_a_row_s)[5], 0.002, 1e-15);
  }
  inputs.row_sizes.assign(6, 0);
  EXPECT_EQ(way_m(0.024), std::vector<double>(6, 0));
}

}  // namespace
}  // namespace fissure::simulated_model_test
