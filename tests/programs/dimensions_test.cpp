// Dimensional analysis: a scene whose lengths, masses and times are multiplied gives the same results,
// multiplied.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "program.h"
#include "store/read_series.h"
#include "text/scalars.h"

namespace fissure::programs::dimensions_test {
namespace {

/// Units of length, mass and time, in metres, kilograms and seconds.
struct Units {
  double m = 1, kg = 1, s = 1;
};

/// A blade on a virtual coupling that presses an elastic ball, all of it in these units.
std::string elasticPress(const Units& u) {
  const auto length = [&](double value_m) { return formatReal(value_m * u.m); };
  const auto time = [&](double value_s) { return formatReal(value_s * u.s); };
  const double pascal = u.kg / (u.m * u.s * u.s);
  return fmt::format(
      "format: 1\nname: press\n"
      "time: {{step_s: {}, duration_s: {}}}\n"
      "world: {{gravity_m_s2: [0, {}, 0]}}\n"
      "bodies:\n"
      "  - name: ball\n"
      "    shape: {{type: sphere, radius_m: {}, subdivisions: 1}}\n"
      "    margin_m: {}\n"
      "    model: elastic\n"
      "    elastic: {{youngs_modulus_Pa: {}, poissons_ratio: 0.4, density_kg_m3: {}, viscosity_Pa_s: {}, "
      "friction: 0.5}}\n"
      "    fixed: [{{below_m: {}}}]\n"
      "tools:\n"
      "  - name: blade\n"
      "    shape: {{type: box, size_m: [{}, {}, {}]}}\n"
      "    nodes: {{resolution: [8, 8]}}\n"
      "    coupling: {{mass_kg: {}, stiffness_N_m: {}, damping_N_s_m: {}, force: reaction}}\n"
      "    motion:\n"
      "      type: script\n"
      "      start_m: [0, {}, 0]\n"
      "      segments: [{{move_to_m: [0, {}, 0], speed_m_s: {}}}]\n"
      "pipelines: [{{pipeline: fukuhara}}, {{pipeline: swept}}]\n"
      "force: [{{name: hc, model: hunt_crossley, k: {}, lambda: {}, n: 1.5, per_area: true}}]\n",
      time(0.001), time(0.1), formatReal(-9.81 * u.m / (u.s * u.s)), length(0.03), length(0.0005),
      formatReal(10000 * pascal), formatReal(1000 * u.kg / (u.m * u.m * u.m)), formatReal(5 * pascal * u.s),
      length(-0.02), length(0.04), length(0.002), length(0.015), formatReal(0.05 * u.kg),
      formatReal(500 * u.kg / (u.s * u.s)), formatReal(5 * u.kg / u.s), length(0.032), length(0.025),
      formatReal(0.1 * u.m / u.s), formatReal(1e5 * pascal * std::pow(u.m, -1.5)),
      formatReal(1e4 * pascal * u.s * std::pow(u.m, -2.5)));
}

/// Expects `series` of the scaled result to be `factor` times that of the first one, to `share` of its
/// largest value.
void expectScaled(const Folder& folder, const std::string& series, double factor, double share) {
  const SeriesData one = readSeries(folder / "one.h5", series),
                   scaled = readSeries(folder / "scaled.h5", series);
  ASSERT_EQ(one.values.size(), scaled.values.size()) << series;
  double largest = 0;
  for (const double value : one.values) largest = std::max(largest, std::abs(value));
  ASSERT_GT(largest, 0) << series;
  for (std::size_t i = 0; i < one.values.size(); ++i)
    ASSERT_LE(std::abs(scaled.values[i] / factor - one.values[i]), share * largest)
        << series << ", value " << i << ": " << one.values[i] << " and " << scaled.values[i] << " / "
        << factor;
}

class Dimensions : public testing::TestWithParam<Units> {};

TEST_P(Dimensions, AScaledSceneHasScaledResults) {
  const Units u = GetParam();
  const Folder folder;
  folder.write("one.yaml", elasticPress({}));
  folder.write("scaled.yaml", elasticPress(u));
  for (const std::string name : {"one", "scaled"}) {
    const Outcome run = runFissure(folder, {"run", name + ".yaml", "-o", name + ".h5"});
    ASSERT_EQ(run.code, 0) << run.err;
  }
  const double newton = u.kg * u.m / (u.s * u.s);
  for (const std::string pipeline : {"/pipelines/fukuhara/", "/pipelines/swept/"}) {
    expectScaled(folder, pipeline + "tool_position", u.m, 1e-6);
    expectScaled(folder, pipeline + "reaction_force", newton, 1e-5);
    expectScaled(folder, pipeline + "force", newton, 1e-5);
    expectScaled(folder, pipeline + "stored_energy", newton * u.m, 1e-5);
    expectScaled(folder, pipeline + "max_pressure", newton / (u.m * u.m), 1e-5);
  }
}

// Powers of two first, which round as one does; then a large, heavy, slow world, and a small, light, fast
// one.
INSTANTIATE_TEST_SUITE_P(OfUnits, Dimensions,
                         testing::Values(Units{2, 1, 1}, Units{1, 8, 1}, Units{1, 1, 0.25}, Units{7, 30, 3},
                                         Units{0.3, 0.02, 0.4}));

}  // namespace
}  // namespace fissure::programs::dimensions_test
