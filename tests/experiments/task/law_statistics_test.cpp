// What a sweep keeps of many sets of laws, beside each law's values in each step.
#include "task/law_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace fissure::law_statistics_test {

namespace {

ForceSettings huntCrossley(double k, double lambda) {
  return {
      .name = "hc", .model = ForceModel::hunt_crossley, .coefficients = {.k = k, .lambda = lambda, .n = 1.3}};
}

/// Contact comes and goes: of a hundred steps every seventh has no triangle.
std::vector<State> states() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> side(-1, 1);
  std::vector<State> states(100);
  for (std::size_t s = 0; s < states.size(); ++s) {
    states[s].step = static_cast<long long>(s);
    for (std::size_t i = 0; i < s % 7; ++i)
      states[s].law_inputs.push_back(
          {0.001 * (1.1 + side(random)), side(random), 1e-5, Vec3(side(random), side(random), side(random))});
  }
  return states;
}

double valueOf(const Summary& summary, const std::string& name) {
  for (const SummaryValue& value : summary)
    if (value.name == name) return std::get<double>(value.value);
  throw std::out_of_range(name);
}

void expectValuesInTurn(const std::vector<State>& states, bool asks_in_between) {
  const std::vector<ForceSettings> laws = {huntCrossley(200, 50), huntCrossley(3, 0), huntCrossley(1e3, 1e3)};
  LawStatistics statistics({{laws[0]}, {laws[1]}, {laws[2]}}, {laws[0]});
  ASSERT_EQ(statistics.rows(), 3);
  for (const State& state : states) {
    statistics.add(state);
    if (asks_in_between && state.step % 5 == 0) statistics.evaluate();
  }
  statistics.evaluate();
  for (std::size_t row = 0; row < laws.size(); ++row) {
    LawFamily alone({laws[row]}, {laws[0]});
    RunningMax max_N;
    Roughness roughness;
    long long non_finite_at_step = -1;
    for (const State& state : states) {
      alone.evaluate(state.law_inputs);
      max_N.add(alone.value(0).force_N);
      roughness.add(alone.value(0).force_N);
      if (non_finite_at_step < 0 && !std::isfinite(alone.value(0).force_N)) non_finite_at_step = state.step;
    }
    Summary summary;
    statistics.summarize(row, summary);
    if (non_finite_at_step < 0) {
      EXPECT_GT(max_N.value(), 0);
      EXPECT_EQ(valueOf(summary, "max_force_N"), max_N.value());
      EXPECT_EQ(valueOf(summary, "force_roughness_hc"), roughness.value());
      EXPECT_TRUE(std::isnan(valueOf(summary, "force_non_finite_at_step_hc")));
    } else {
      EXPECT_TRUE(std::isnan(valueOf(summary, "max_force_hc_N")));
      EXPECT_EQ(valueOf(summary, "force_non_finite_at_step_hc"), static_cast<double>(non_finite_at_step));
    }
    EXPECT_EQ(statistics.value(row).elastic_N, alone.value(0).elastic_N) << "in the last step";
  }
}

TEST(LawStatistics, AreThoseOfEachStepInTurn) {
  for (const bool asks_in_between : {false, true}) expectValuesInTurn(states(), asks_in_between);
}

TEST(LawStatistics, NameTheFirstStepWithoutANumber) {
  std::vector<State> broken = states();
  for (const std::size_t step : {std::size_t{41}, std::size_t{55}})
    broken[step].law_inputs.at(0).deformation_m = std::numeric_limits<double>::quiet_NaN();
  for (const bool asks_in_between : {false, true}) expectValuesInTurn(broken, asks_in_between);
}

TEST(LawStatistics, OfNoStepAreMissing) {
  LawStatistics statistics({{huntCrossley(200, 50)}}, {huntCrossley(200, 50)});
  statistics.evaluate();
  Summary summary;
  statistics.summarize(0, summary);
  EXPECT_TRUE(std::isnan(valueOf(summary, "max_force_N")));
}

}  // namespace
}  // namespace fissure::law_statistics_test
