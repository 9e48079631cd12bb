// Forces as a user finds them in a result.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"
#include "scenarios.h"
#include "store/read_series.h"
#include "store/result_file.h"

namespace fissure::programs::force_test {
namespace {

const std::string laws =
    "force:\n"
    "  - {name: hc, model: hunt_crossley}\n"
    "  - {name: kv, model: kelvin_voigt, k: 200, c: 2}\n"
    "  - {name: area, model: hunt_crossley, k: 2.3e6, lambda: 5.8e5, n: 1.3, per_area: true, deformation: "
    "corotated}\n";

std::string withLimit(const std::string& limit_N) {
  return with(pressScenario("[{pipeline: fukuhara}]", "0.03", laws), "    motion:\n",
              "    force_limit_N: " + limit_N + "\n    motion:\n");
}

long long scalar(const ResultInfo& info, const std::string& name) {
  for (const SummaryValue& value : info.pipelines.at(0).summary)
    if (value.name == name) return std::get<long long>(value.value);
  ADD_FAILURE() << "no " << name;
  return -1;
}

TEST(Force, SaturationIsFlaggedAgainstTheDevicesLimit) {
  const Folder folder;
  folder.write("s.yaml", withLimit("2"));
  EXPECT_NE(runFissure(folder, {"plan", "s.yaml"}).out.find("device limit 2 N"), std::string::npos);
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const std::string group = "/pipelines/fukuhara/";
  const SeriesData force = readSeries(folder / "out.h5", group + "tool_force");
  const SeriesData total = readSeries(folder / "out.h5", group + "force");
  const SeriesData saturated = readSeries(folder / "out.h5", group + "saturated");
  ASSERT_EQ(force.shape, (std::vector<std::size_t>{3, 31, 1, 3}));
  ASSERT_EQ(saturated.shape, (std::vector<std::size_t>{3, 31, 1}));
  EXPECT_EQ(force.values, total.values) << "the only tool feels all of it";
  long long beyond = 0;
  for (std::size_t i = 0; i < 3 * 31; ++i) {
    const double* at = &force.values[3 * i];
    const bool expected = std::hypot(at[0], at[1], at[2]) > 2;
    EXPECT_EQ(saturated.values[i], expected ? 1 : 0);
    if (i < 31) beyond += expected ? 1 : 0;
  }
  EXPECT_GT(beyond, 0);
  EXPECT_LT(beyond, 31);
  EXPECT_EQ(scalar(readResultInfo(folder / "out.h5"), "saturated_steps"), beyond);
}

// 1e308 N/m overflows; tissue, tool and the other law are as without it.
TEST(Force, ALawThatOverflowsIsNamedWithItsStep) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03",
                                       "force:\n  - {name: hc, model: hunt_crossley}\n"
                                       "  - {name: huge, model: linear_elastic, k: 1e308}\n"));
  const Outcome run = runFissure(folder, {"run", "s.yaml", "-o", "out.h5"});
  EXPECT_EQ(run.code, 0) << "the simulation is sound";
  const ResultInfo info = readResultInfo(folder / "out.h5");
  const long long step = scalar(info, "force_non_finite_at_step_huge");
  const SeriesData force = readSeries(folder / "out.h5", "/pipelines/fukuhara/force");
  for (long long i = 0; i < 31; ++i) {
    const double* at = &force.values[static_cast<std::size_t>(3 * (31 + i))];
    const bool finite = std::isfinite(std::sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]));
    EXPECT_TRUE(i < step ? finite : i > step || !finite) << i;
  }
  const std::string line =
      "fukuhara: the force of law huge is not finite, first at step " + std::to_string(step) + "\n";
  for (const std::string& shown : {run.out, runFissure(folder, {"info", "out.h5"}).out}) {
    EXPECT_NE(shown.find(line), std::string::npos) << shown;
    EXPECT_EQ(shown.find("law hc"), std::string::npos) << shown;
  }
}

TEST(Force, WithoutADeviceNothingIsSaturated) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03", laws));
  const Outcome plan = runFissure(folder, {"plan", "s.yaml"});
  EXPECT_EQ(plan.out.find("device limit"), std::string::npos);
  EXPECT_NE(plan.out.find("force: area (hunt_crossley, corotated, per area)"), std::string::npos);
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  for (const DatasetInfo& dataset : readResultInfo(folder / "out.h5").datasets)
    EXPECT_FALSE(dataset.path.ends_with("/saturated"));
}

}  // namespace
}  // namespace fissure::programs::force_test
