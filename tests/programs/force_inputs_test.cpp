// Force laws evaluated after the run from what its own laws saw: the same numbers as if they had been in it.
#include "store/force_inputs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "program.h"
#include "scenario/load.h"
#include "scenarios.h"
#include "store/read_series.h"
#include "task/law_family.h"

namespace fissure::programs::force_inputs_test {
namespace {

/// Pressed in and drawn back, so that triangles pull.
std::string pressAndLeave(const std::string& laws) {
  return with(pressScenario("[{pipeline: fukuhara}, {name: default, pipeline: default, settings: tuned}]",
                            "0.06", laws),
              "speed_m_s: 0.5}\n", "speed_m_s: 0.5}\n        - {move_to_m: [0, 0.062, 0], speed_m_s: 0.5}\n");
}

const std::string recorded_laws =
    "force:\n"
    "  - {name: hc, model: hunt_crossley, lambda: 5000}\n"
    "  - {name: engine, model: kelvin_voigt, rate: velocities}\n"
    "  - {name: turned, model: linear_elastic, deformation: corotated}\n"
    "record: {force_inputs: true}\n";

const std::string other_laws =
    "force:\n"
    "  - {name: stiff, model: hunt_crossley, k: 900, lambda: 30, n: 1.1}\n"
    "  - {name: sticky, model: hunt_crossley, k: 50, lambda: 3000, n: 1.7}\n"
    "  - {name: sticky_area, model: hunt_crossley, k: 5e5, lambda: 3e7, n: 1.7, per_area: true}\n"
    "  - {name: kv, model: kelvin_voigt, k: 300, c: 8}\n"
    "  - {name: kv_engine, model: kelvin_voigt, k: 300, c: 8, rate: velocities}\n"
    "  - {name: turned, model: hunt_crossley, k: 200, lambda: 900, n: 1.3, deformation: corotated}\n"
    "  - {name: linear, model: linear_elastic, k: 120, per_area: true}\n";

/// value(law, time), or its length over xyz.
double at(const SeriesData& series, std::size_t law, std::size_t row) {
  const std::size_t width = series.shape.size() == 3 ? 3 : 1;
  const double* value = &series.values[(law * series.shape[1] + row) * width];
  return width == 3 ? Vec3::Map(value).norm() : *value;
}

/// Evaluates `laws` from what the run in `inputs_file` saw, and expects what the run in `series_file` says.
void expectRecorded(const Folder& folder, const std::string& inputs_file, const std::string& series_file,
                    const std::string& pipeline) {
  const Scenario seen = loadScenario(folder / "recorded.yaml").scenario;
  const Scenario evaluated = loadScenario(folder / (series_file + ".yaml")).scenario;
  const ForceInputs inputs = readForceInputs(folder / (inputs_file + ".h5"), pipeline);
  const auto series = [&](const std::string& name) {
    return readSeries(folder / (series_file + ".h5"), "/pipelines/" + pipeline + "/" + name);
  };
  const SeriesData force = series("force"), elastic = series("force_elastic"),
                   viscous = series("force_viscous"), clamped = series("adhesion_clamped");
  ASSERT_EQ(inputs.times_s, series("time").values);
  LawFamily family(evaluated.force, seen.force);
  double clamped_sum = 0, force_max_N = 0;
  auto from = inputs.inputs.begin();
  for (std::size_t row = 0; row < inputs.times_s.size(); ++row) {
    const auto to = from + static_cast<std::ptrdiff_t>(inputs.row_sizes[row] * inputs.laws.size());
    family.evaluate({from, to});
    from = to;
    for (std::size_t law = 0; law < evaluated.force.size(); ++law) {
      const LawValue value = family.value(law);
      const double rounding_N = 1e-12 * (at(elastic, law, row) + std::abs(at(viscous, law, row)));
      const std::string where = evaluated.force[law].name + " in row " + std::to_string(row);
      ASSERT_NEAR(value.force_N, at(force, law, row), rounding_N) << where;
      ASSERT_NEAR(value.elastic_N, at(elastic, law, row), rounding_N) << where;
      ASSERT_NEAR(value.viscous_N, at(viscous, law, row), rounding_N) << where;
      ASSERT_EQ(value.adhesion_clamped, at(clamped, law, row)) << where;
      clamped_sum += value.adhesion_clamped;
      force_max_N = std::max(force_max_N, value.force_N);
    }
  }
  EXPECT_EQ(from, inputs.inputs.end());
  EXPECT_GT(clamped_sum, 0) << "no triangle pulls, no test";
  EXPECT_GT(force_max_N, 1);
}

TEST(ForceInputs, OtherLawsFromThemAreThoseOfARunOfTheirOwn) {
  const Folder folder;
  folder.write("recorded.yaml", pressAndLeave(recorded_laws));
  folder.write("others.yaml", pressAndLeave(other_laws));
  for (const std::string name : {"recorded", "others"})
    ASSERT_EQ(runFissure(folder, {"run", name + ".yaml", "-o", name + ".h5"}).code, 0);
  for (const std::string pipeline : {"fukuhara", "default"}) {
    expectRecorded(folder, "recorded", "recorded", pipeline);
    expectRecorded(folder, "recorded", "others", pipeline);
  }
}

TEST(ForceInputs, ArePlannedShownAndAbsentUnlessAskedFor) {
  const Folder folder;
  folder.write("asked.yaml", pressScenario("[{pipeline: fukuhara}]", "0.005", recorded_laws));
  folder.write("not.yaml", with(folder.read("asked.yaml"), "force_inputs: true", ""));
  folder.write("lawless.yaml",
               pressScenario("[{pipeline: fukuhara}]", "0.005", "record: {force_inputs: true}\n"));
  for (const bool asked : {true, false}) {
    const std::string name = asked ? "asked" : "not";
    const Outcome plan = runFissure(folder, {"plan", name + ".yaml"});
    EXPECT_EQ(plan.out.find("force inputs: what 3 laws see of each colliding triangle; 96 B a triangle") !=
                  std::string::npos,
              asked)
        << plan.out;
    ASSERT_EQ(runFissure(folder, {"run", name + ".yaml", "-o", name + ".h5"}).code, 0);
    const std::string info = runFissure(folder, {"info", name + ".h5"}).out;
    EXPECT_EQ(info.find("/pipelines/fukuhara/force_inputs/deformation_rate") != std::string::npos, asked)
        << info;
    EXPECT_EQ(info.find("/obs") != std::string::npos, asked) << info;
  }
  const Outcome lawless = runFissure(folder, {"validate", "lawless.yaml"});
  EXPECT_EQ(lawless.code, 2);
  EXPECT_NE(lawless.err.find("record.force_inputs is true, but the scenario has no force law"),
            std::string::npos)
      << lawless.err;
}

}  // namespace
}  // namespace fissure::programs::force_inputs_test
