// record.every and measure.every: fewer rows and fewer looks, and what of a run stays the same.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"
#include "scenarios.h"
#include "store/read_series.h"
#include "store/result_file.h"
#include "sweeps.h"

namespace fissure::programs::thinned_test {

namespace {

const std::string& laws_and_proof() {
  static const std::string text = "force: [{name: hc, model: hunt_crossley}]\nmeasure: {certify: true}\n";
  return text;
}

Summary summaryOf(const std::filesystem::path& result) {
  return readResultInfo(result).pipelines.at(0).summary;
}

const SummaryValue* find(const Summary& summary, const std::string& name) {
  for (const SummaryValue& value : summary)
    if (value.name == name) return &value;
  return nullptr;
}

SeriesData series(const std::filesystem::path& result, const std::string& name) {
  return readSeries(result, "/pipelines/fukuhara/" + name);
}

/// Rows of a thinned run, at steps 0, 7, 14, 21, 28 and 30, against those of the whole run.
void expectRowsOf(const std::filesystem::path& thinned, const std::filesystem::path& whole,
                  const std::string& name) {
  const SeriesData some = series(thinned, name), all = series(whole, name);
  ASSERT_EQ(some.values.size(), 6u) << name;
  const std::size_t steps[] = {0, 7, 14, 21, 28, 30};
  for (std::size_t row = 0; row < 6; ++row)
    EXPECT_EQ(some.values[row], all.values[steps[row]]) << name << ", step " << steps[row];
}

// All but the series is that of the whole run, bit for bit.
TEST(Thinned, RowsAreFewerAndTheSummaryIsTheSame) {
  const Folder folder;
  folder.write("whole.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03", laws_and_proof()));
  folder.write("rows.yaml",
               pressScenario("[{pipeline: fukuhara}]", "0.03", laws_and_proof() + "record: {every: 7}\n"));
  for (const char* name : {"whole", "rows"})
    ASSERT_EQ(runFissure(folder, {"run", std::string(name) + ".yaml", "-o", std::string(name) + ".h5"}).code,
              0);
  for (const char* name : {"time", "penetration_depth", "stand_off", "certified", "contact_count"})
    expectRowsOf(folder / "rows.h5", folder / "whole.h5", name);
  const Summary whole = summaryOf(folder / "whole.h5"), rows = summaryOf(folder / "rows.h5");
  ASSERT_EQ(rows.size(), whole.size());
  for (const SummaryValue& value : whole) {
    if (value.name.starts_with("timing/")) continue;
    const SummaryValue* same = find(rows, value.name);
    ASSERT_NE(same, nullptr) << value.name;
    const double* real = std::get_if<double>(&value.value);
    if (real && std::isnan(*real))
      EXPECT_TRUE(std::isnan(std::get<double>(same->value))) << value.name;
    else
      EXPECT_EQ(same->value, value.value) << value.name;
  }
}

// Depth and proof are those of the steps looked at; contacts and forces are those of all steps.
TEST(Thinned, MeasurementsAreFewerAndTheRunSaysSo) {
  const Folder folder;
  folder.write("whole.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03", laws_and_proof()));
  folder.write("thin.yaml", with(pressScenario("[{pipeline: fukuhara}]", "0.03", laws_and_proof()),
                                 "{certify: true}", "{certify: true, every: 7}"));
  ASSERT_EQ(runFissure(folder, {"run", "whole.yaml", "-o", "whole.h5"}).code, 0);
  const Outcome thin = runFissure(folder, {"run", "thin.yaml", "-o", "thin.h5"});
  ASSERT_EQ(thin.code, 0) << thin.err;
  for (const char* name :
       {"time", "penetration_depth", "inversion_aware_depth", "stand_off", "contact_count"})
    expectRowsOf(folder / "thin.h5", folder / "whole.h5", name);
  const Summary whole = summaryOf(folder / "whole.h5"), summary = summaryOf(folder / "thin.h5");
  EXPECT_EQ(std::get<long long>(find(summary, "certified_steps")->value), 6);
  EXPECT_EQ(std::get<long long>(find(summary, "steps_per_measurement")->value), 7);
  EXPECT_EQ(find(whole, "steps_per_measurement"), nullptr);
  for (const char* name : {"steps", "final_state_hash", "max_force_N", "max_reaction_N", "contacts_total"})
    EXPECT_EQ(find(summary, name)->value, find(whole, name)->value) << name;
  EXPECT_NE(thin.out.find("depth and proof of one step in 7 only"), std::string::npos) << thin.out;
  EXPECT_EQ(thin.out.find("held, proved"), std::string::npos) << "not in each step\n" << thin.out;
}

TEST(Thinned, RowsWithoutMeasurementsAreRefused) {
  const Folder folder;
  folder.write("s.yaml",
               pressScenario("[{pipeline: fukuhara}]", "0.03", "record: {every: 10}\nmeasure: {every: 4}\n"));
  const Outcome outcome = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("record.every is 10, expected a multiple of measure.every, 4"),
            std::string::npos)
      << outcome.err;
}

// A picture of a step without a row would have no depth to show.
TEST(Thinned, SnapshotsBetweenRowsAreRefused) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03",
                                       "record: {every: 10, snapshots_every_s: 0.015}\n"));
  const Outcome outcome = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(
      outcome.err.find("snapshots_every_s is 0.015, expected a multiple of the time between two rows, 0.01"),
      std::string::npos)
      << outcome.err;
  folder.write("t.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03",
                                       "record: {every: 10, snapshots_every_s: 0.02}\n"));
  EXPECT_EQ(runFissure(folder, {"validate", "t.yaml"}).code, 0);
}

TEST(Thinned, CurvesThatBeginWithFirstContactNeedARowPerStep) {
  const Folder folder;
  folder.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03", "record: {every: 7}\n"));
  folder.write("s.yaml", sweepOf("axes: [{path: bodies.sphere.mass_kg, values: [0.1, 0.2]}]\n"
                                 "curves: {quantities: [indentation], every_s: 0.007}\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("the record has a row every 7 steps, expected every step for the curve "
                             "`indentation`, which begins with the first in contact"),
            std::string::npos)
      << outcome.err;
}

}  // namespace

}  // namespace fissure::programs::thinned_test
