#include "fit/modulus_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"

namespace fissure::modulus_fit_test {

namespace {

/// A press as Hertz has it, F = 3 N (d/mm)^1.5 at 10 kPa, in 401 steps to 4 mm.
PressCurve press() {
  PressCurve press{.label = "press.h5:swept", .youngs_modulus_Pa = 1e4, .poissons_ratio = 0.49};
  for (int i = 0; i <= 400; ++i) {
    press.depth_m.push_back(1e-5 * i);
    press.force_N.push_back(3 * std::pow(0.01 * i, 1.5));
  }
  return press;
}

/// E/E0 f(d + d0) + F0 at every half millimetre to 3 mm, quartiles a tenth beside it.
MeasuredCurve measured(const PressCurve& press, double E_Pa, double F0_N, double d0_m) {
  MeasuredCurve curve;
  curve.name = "probe";
  for (int i = 1; i <= 6; ++i) {
    curve.depth_m.push_back(5e-4 * i);
    curve.force_N.push_back(E_Pa / 1e4 * press.force(5e-4 * i + d0_m) + F0_N);
    curve.weights.push_back(i % 2 == 0 ? 1 : 4);
    curve.lower_quartile_N.push_back(0.9 * curve.force_N.back());
    curve.upper_quartile_N.push_back(1.1 * curve.force_N.back());
  }
  return curve;
}

ModulusSettings free(bool E, bool F0, bool d0, double most_depth_m = 1) {
  return {.free = {E, F0, d0}, .fixed = {1e4, 0, 0}, .most_depth_m = most_depth_m};
}

std::string problemOf(const PressCurve& press, const MeasuredCurve& curve, const ModulusSettings& settings) {
  try {
    fitModulus(press, curve, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST(ModulusFit, FindsTheModulusAndTheOffsetsThatACurveWasMadeWith) {
  const PressCurve simulated = press();
  for (const double E_Pa : {2e3, 7.3e4}) {
    ModulusFit fit =
        fitModulus(simulated, measured(simulated, E_Pa, 0.05, 0), free(true, true, false, 0.0021));
    EXPECT_TRUE(fit.converged);
    EXPECT_EQ(fit.points, 4u);
    EXPECT_NEAR(fit.of(ModulusParameter::modulus).value, E_Pa, 1e-6 * E_Pa);
    EXPECT_NEAR(fit.of(ModulusParameter::force_offset).value, 0.05, 1e-6 * 0.05);
    EXPECT_EQ(fit.of(ModulusParameter::depth_offset).value, 0);
    ASSERT_EQ(fit.predictions.size(), 2u);
    EXPECT_NEAR(fit.predictions[1].predicted_N, fit.predictions[1].measured_N, 1e-6);
    EXPECT_NEAR(fit.predictions[1].lower_quartile_N, 0.9 * fit.predictions[1].measured_N, 1e-12);
    fit = fitModulus(simulated, measured(simulated, E_Pa, 0, 4.2e-4), free(true, false, true));
    EXPECT_NEAR(fit.of(ModulusParameter::modulus).value, E_Pa, 1e-6 * E_Pa);
    EXPECT_NEAR(fit.of(ModulusParameter::depth_offset).value, 4.2e-4, 1e-6 * 4.2e-4);
    fit = fitModulus(simulated, measured(simulated, E_Pa, -0.02, 3e-4), free(true, true, true));
    EXPECT_NEAR(fit.of(ModulusParameter::modulus).value, E_Pa, 1e-6 * E_Pa);
    EXPECT_NEAR(fit.of(ModulusParameter::force_offset).value, -0.02, 1e-6);
    EXPECT_NEAR(fit.of(ModulusParameter::depth_offset).value, 3e-4, 1e-9);
  }
}

// E and F0 are a straight line's: its interval in closed form.
TEST(ModulusFit, IntervalsOfALinearFitAreThoseOfALine) {
  const PressCurve simulated = press();
  MeasuredCurve curve = measured(simulated, 1e4, 0.05, 0);
  curve.weights.assign(6, 1);
  const double errors_N[] = {0.1, -0.2, 0.05, 0.15, -0.12, 0.02};
  double mean_f = 0, mean_F = 0, ff = 0, fF = 0, rest = 0;
  std::vector<double> f;
  for (std::size_t i = 0; i < 6; ++i) {
    curve.force_N[i] += errors_N[i];
    f.push_back(simulated.force(curve.depth_m[i]));
    mean_f += f[i] / 6;
    mean_F += curve.force_N[i] / 6;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    ff += (f[i] - mean_f) * (f[i] - mean_f);
    fF += (f[i] - mean_f) * (curve.force_N[i] - mean_F);
  }
  const double slope = fF / ff;
  for (std::size_t i = 0; i < 6; ++i)
    rest += std::pow(curve.force_N[i] - mean_F - slope * (f[i] - mean_f), 2);
  const double error = std::sqrt(rest / 4 / ff), t4 = 2.776445105;
  const ModulusFit fit = fitModulus(simulated, curve, free(true, true, false));
  const ModulusValue& modulus = fit.of(ModulusParameter::modulus);
  EXPECT_NEAR(modulus.value, 1e4 * slope, 1e-4 * slope);
  EXPECT_NEAR(modulus.standard_error, 1e4 * error, 1e4 * error * 1e-4);
  EXPECT_NEAR(modulus.low, 1e4 * (slope - t4 * error), 1e4 * error * 1e-3);
  EXPECT_NEAR(modulus.high, 1e4 * (slope + t4 * error), 1e4 * error * 1e-3);
  EXPECT_NEAR(fit.rms_N, std::sqrt(rest / 6), 1e-9);
  EXPECT_NEAR(fit.correlation[0][1], -mean_f / std::sqrt(ff / 6 + mean_f * mean_f), 1e-4);
  EXPECT_GT(fit.of(ModulusParameter::force_offset).high, 0.05);
}

TEST(ModulusFit, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const PressCurve simulated = press();
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.02);
  int E_held = 0, d0_held = 0, beyond_held = 0;
  for (int trial = 0; trial < 200; ++trial) {
    MeasuredCurve curve = measured(simulated, 2e4, 0, 3e-4);
    for (std::size_t i = 0; i < curve.force_N.size(); ++i)
      curve.force_N[i] += noise(random) / std::sqrt(curve.weights[i]);
    const ModulusFit fit = fitModulus(simulated, curve, free(true, false, true, 0.0026));
    const auto holds = [](const ModulusValue& value, double truth) {
      return value.low <= truth && truth <= value.high;
    };
    E_held += holds(fit.of(ModulusParameter::modulus), 2e4) ? 1 : 0;
    d0_held += holds(fit.of(ModulusParameter::depth_offset), 3e-4) ? 1 : 0;
    const double truth_N = 2 * simulated.force(0.0033);
    beyond_held += std::abs(fit.predictions.at(0).predicted_N - truth_N) <=
                           fit.predictions[0].high_N - fit.predictions[0].predicted_N
                       ? 1
                       : 0;
  }
  for (const int held : {E_held, d0_held, beyond_held}) {
    EXPECT_GE(held, 178);  // 190 -+ 4 standard deviations
    EXPECT_LE(held, 200);
  }
}

TEST(ModulusFit, SaysWhatTheDataDoesNotTell) {
  const PressCurve simulated = press();
  MeasuredCurve curve = measured(simulated, 1e4, 0, 0);
  for (std::size_t i = 0; i < 6; ++i) curve.force_N[i] += i % 2 == 0 ? 3 : -3;
  ModulusFit fit = fitModulus(simulated, curve, free(true, true, false, 0.0021));
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_TRUE(fit.notes[0].starts_with("E has an interval with an open end")) << fit.notes[0];
  EXPECT_EQ(fit.of(ModulusParameter::modulus).low, 0);
  fit = fitModulus(simulated, measured(simulated, 1e4, 0, 0.001), free(true, true, true, 0.0026));
  const auto same = std::find_if(fit.notes.begin(), fit.notes.end(), [](const std::string& note) {
    return note.starts_with("E and d0 do nearly the same here (correlation -0.9");
  });
  EXPECT_NE(same, fit.notes.end());
}

TEST(ModulusFit, NothingIsFittedOrPredictedBelowTheSimulation) {
  const PressCurve simulated = press();
  MeasuredCurve curve = measured(simulated, 1e4, 0.05, 0);
  curve.depth_m.back() = 0.0041;
  EXPECT_EQ(
      problemOf(simulated, curve, free(true, true, false)),
      "a point 4.1 mm deep is deeper than the simulation, which ends at 4 mm, expected a deeper press, or "
      "--most-depth");
  const ModulusFit fit = fitModulus(simulated, curve, free(true, true, false, 0.002));
  EXPECT_EQ(fit.predictions.size(), 1u);
  EXPECT_EQ(fit.notes.back(), "1 point not predicted, deeper than the simulation, which ends at 4 mm");
  EXPECT_EQ(problemOf(simulated, measured(simulated, 1e4, 0, 0.002), free(true, false, true)).substr(0, 27),
            "a point 3 mm deep, moved by");
}

TEST(ModulusFit, RefusesWhatCannotBeFitted) {
  const PressCurve simulated = press();
  MeasuredCurve curve = measured(simulated, 1e4, 0.05, 0);
  EXPECT_EQ(problemOf(simulated, curve, free(true, true, false, 0.0011)),
            "2 points for 2 free parameters, expected more points than these");
  EXPECT_EQ(problemOf(simulated, pointsOf(curve, {2, 2, 2, 2}), free(true, true, false)),
            "what is free does the same at its points, expected fewer in --free, or more depths");
  curve.depth_m.clear();
  EXPECT_EQ(problemOf(simulated, curve, free(true, true, false)),
            "the curve has no depths, expected a column of them");
  curve = measured(simulated, 1e4, 0, 0);
  curve.force_N.assign(6, 0);
  EXPECT_EQ(problemOf(simulated, curve, free(true, true, false)),
            "every force is 0, expected forces of a press");
}

TEST(PressCurve, CountsDepthAlongTheMotionFromTheStepBeforeTheFirstReaction) {
  std::vector<double> positions_m, reactions_N;
  const auto step = [&](double way_m, double force_N) {  // obliquely into x and -y; friction across it
    positions_m.insert(positions_m.end(), {0.6 * way_m, 0.1 - 0.8 * way_m, 0});
    reactions_N.insert(reactions_N.end(), {-0.6 * force_N, 0.8 * force_N, 0.3 * force_N});
  };
  for (const auto& [way_m, force_N] : std::vector<std::pair<double, double>>{
           {0, 0}, {1e-3, 0}, {2e-3, 1}, {4e-3, 3}, {3e-3, 9}, {5e-3, 5}, {1e-3, 0}})
    step(way_m, force_N);
  PressCurve made;
  takePress(positions_m, reactions_N, made);
  ASSERT_EQ(made.depth_m.size(), 4u);
  const double depths_m[] = {0, 1e-3, 3e-3, 4e-3}, forces_N[] = {0, 1, 3, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(made.depth_m[i], depths_m[i], 1e-12);
    EXPECT_NEAR(made.force_N[i], forces_N[i], 1e-12);
  }
  EXPECT_NEAR(made.first_step_m, 1e-3, 1e-12);
  EXPECT_NEAR(made.force(2e-3), 2, 1e-12);
  EXPECT_EQ(made.force(-1e-3), 0);
  EXPECT_NEAR(made.force(5e-3), 7, 1e-12);
}

TEST(PressCurve, RefusesWhatIsNoPress) {
  const auto problem = [](const std::vector<double>& positions_m, const std::vector<double>& reactions_N) {
    PressCurve made;
    try {
      takePress(positions_m, reactions_N, made);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(problem({0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 0}),
            "its tool never meets the body, expected a press");
  EXPECT_EQ(problem({0, 1, 0, 0, 1, 0}, {0, 1, 0, 0, 1, 0}),
            "its tool does not move in contact, expected a press");
  EXPECT_EQ(problem({0, 0, 0, 0, 1, 0}, {NAN, NAN, NAN, NAN, NAN, NAN}),
            "its reaction is not measured, expected a pipeline that measures reaction_force");
}

}  // namespace fissure::modulus_fit_test
