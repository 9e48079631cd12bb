// What the comparison of two runs finds, on made-up results of 10,000 steps.
#include "compare/compare_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/error.h"
#include "store/reference_file.h"
#include "store/sample_run.h"

namespace fissure::compare_runs_test {

namespace {

constexpr std::size_t kRows = 10'000;

/// What a test changes about the run that it writes.
struct Changes {
  std::function<void(const RecordLayout&, std::size_t row, RecordRow&)> row = {};
  std::function<void(std::size_t snapshot, State&)> snapshot = {};
  std::function<void(std::size_t row, State&)> inputs = {};
  std::function<void(SampleRun&)> run = {};
  Summary summary = {
      {"max_penetration_depth_m", 0.25}, {"steps", 12LL}, {"final_state_hash", std::string("abc")}};
  std::size_t rows = kRows;
};

class CompareRuns : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const Changes& changes = {}) {
    SampleRun run = makeSampleRun(changes.rows, true);
    run.scenario.pipelines.resize(1);
    if (changes.run) changes.run(run);
    const auto part = folder_ / (name + ".part");
    const auto sink = openSamplePart(part, run, "paper_method");
    for (std::size_t i = 0; i < run.rows; ++i) {
      RecordRow row = sampleRow(run.layout, i);
      if (i == 1)
        row[run.layout.find("penetration_depth")->first_column] = 0;  // the sample's is missing there
      if (changes.row) changes.row(run.layout, i, row);
      if (run.scenario.record.force_inputs) {
        State seen = sampleInputs(i);
        if (changes.inputs) changes.inputs(i, seen);
        sink->forceInputs(seen);
      }
      sink->append(row);
      State state = sampleState(i);
      if (changes.snapshot) changes.snapshot(i, state);
      sink->snapshot(state);
    }
    sink->finish({RunEnd::ok, ""}, changes.summary);
    const auto path = folder_ / (name + ".h5");
    assembleResult(path, loadedSample(run), {}, {{run.scenario.pipelines[0], part, {RunEnd::ok, ""}}});
    return path;
  }
  RunComparison compare(const std::filesystem::path& a, const std::filesystem::path& b,
                        const CompareSettings& settings = {}) {
    infos_ = {readResultInfo(a), readResultInfo(b)};
    return compareRuns({a, &infos_[0], &infos_[0].pipelines[0]}, {b, &infos_[1], &infos_[1].pipelines[0]},
                       settings);
  }
  /// The names of the quantities that do not agree.
  static std::vector<std::string> differing(const RunComparison& comparison) {
    std::vector<std::string> names;
    for (const QuantityComparison& made : comparison.quantities)
      if (!made.agrees) names.push_back(made.quantity);
    return names;
  }
  static const QuantityComparison& find(const RunComparison& comparison, const std::string& name) {
    for (const QuantityComparison& made : comparison.quantities)
      if (made.quantity == name) return made;
    throw std::logic_error("no quantity " + name);
  }
  static Changes changedRow(const char* series, std::size_t at, double value) {
    return {.row = [=](const RecordLayout& layout, std::size_t row, RecordRow& values) {
      if (row == at) values[layout.find(series)->first_column] = value;
    }};
  }
  using Names = std::vector<std::string>;

  ScratchFolder folder_;
  std::vector<ResultInfo> infos_;
};

TEST_F(CompareRuns, ARunEqualsItselfAndItsRepetition) {
  const auto a = write("a"), b = write("b");
  for (const bool exact : {false, true}) {
    EXPECT_TRUE(compare(a, a, {.exact = exact}).agrees());
    const RunComparison comparison = compare(a, b, {.exact = exact});
    EXPECT_TRUE(comparison.agrees());
    EXPECT_GT(comparison.quantities.size(), 20u);
    EXPECT_EQ(find(comparison, "positions").difference.rows, kRows);
  }
}

TEST_F(CompareRuns, OneVertexOffByAMicrometreInOneStepIsFoundAndNamed) {
  const auto a = write("a", {.snapshot = [](std::size_t snapshot, State& state) {
                         if (snapshot == 7654) state.positions_m[5].z() += 1e-6;
                       }});
  const RunComparison comparison = compare(a, write("b"));
  EXPECT_EQ(differing(comparison), Names{"positions"});
  const QuantityComparison& positions = find(comparison, "positions");
  EXPECT_NEAR(positions.difference.largest, 1e-6, 1e-11);
  EXPECT_EQ(positions.difference.count, 1u);
  EXPECT_EQ(positions.worst_at, "snapshot 7654 (7.654 ks), vertex 5, z");
  EXPECT_EQ(positions.first_at, positions.worst_at);
}

TEST_F(CompareRuns, NanOnEitherOrBothSidesFails) {
  const auto bad =
      write("bad", changedRow("penetration_depth", 5000, std::numeric_limits<double>::quiet_NaN()));
  const auto good = write("good");
  for (const auto& [a, b, problem] : {std::tuple{bad, good, "NaN in A at step 5000 (2.5 ks)"},
                                      {good, bad, "NaN in B at step 5000 (2.5 ks)"}}) {
    const RunComparison comparison = compare(a, b);
    EXPECT_EQ(differing(comparison), Names{"penetration_depth"});
    EXPECT_EQ(find(comparison, "penetration_depth").problem, problem);
  }
  const CompareSettings loose{.tolerances = {1, {{.quantity = "*", .absolute = 1e300}}}};
  EXPECT_FALSE(compare(bad, bad).agrees());
  EXPECT_FALSE(compare(bad, bad, {.exact = true}).agrees());
  EXPECT_FALSE(compare(bad, good, loose).agrees());
}

TEST_F(CompareRuns, AMissingDatasetFailsOnBothSides) {
  const auto a = write("a"),
             b = write("b", {.run = [](SampleRun&run) { run.scenario.record.frames.reset(); }});
  const RunComparison comparison = compare(a, b);
  EXPECT_EQ(find(comparison, "frames").problem, "missing in B");
  EXPECT_EQ(find(compare(b, a), "frames").problem, "missing in A");
  EXPECT_FALSE(comparison.agrees());
}

TEST_F(CompareRuns, OtherLengthsAndLabelsFail) {
  const auto b = write("b");
  const RunComparison shorter = compare(write("shorter", {.rows = kRows - 1}), b);
  EXPECT_EQ(find(shorter, "force").problem, "9999 rows over time against 10000");
  EXPECT_EQ(find(shorter, "force").difference.count, 0u);
  EXPECT_FALSE(shorter.agrees());
}

TEST_F(CompareRuns, SummariesAreComparedByNumberAndByText) {
  const auto a = write("a", {.summary = {{"max_penetration_depth_m", 0.2500001},
                                         {"steps", 12LL},
                                         {"final_state_hash", std::string("abd")},
                                         {"extra_m", 1.0}}});
  const RunComparison comparison = compare(a, write("b"));
  EXPECT_EQ(differing(comparison),
            (Names{"summary/max_penetration_depth_m", "summary/final_state_hash", "summary/extra_m"}));
  EXPECT_EQ(find(comparison, "summary/extra_m").problem, "missing in B");
  EXPECT_EQ(find(comparison, "summary/max_penetration_depth_m").units, "m");
}

TEST_F(CompareRuns, TolerancesAreOfTheLargestValueAndOfTheLargestDifference) {
  const auto a = write("a", changedRow("force", 4000, 4000 + 0.9)), b = write("b");
  const double largest = 100 + (kRows - 1) + 0.2;  // of the sample's force
  const auto agrees = [&](const ToleranceRule& rule) {
    return compare(a, b, {.tolerances = {1, {rule}}}).agrees();
  };
  EXPECT_TRUE(agrees({.quantity = "force", .absolute = 0.91}));
  EXPECT_FALSE(agrees({.quantity = "force", .absolute = 0.89}));
  EXPECT_TRUE(agrees({.quantity = "forc?", .relative = 0.91 / largest}));
  EXPECT_FALSE(agrees({.quantity = "forc?", .relative = 0.89 / largest}));
  EXPECT_FALSE(agrees({.quantity = "force", .pipeline = "other", .absolute = 1}));
  EXPECT_TRUE(agrees({.quantity = "*", .ignore = true}));
  // The last rule that fits counts; bit for bit none does.
  const Tolerances overruled{1, {{.quantity = "*", .absolute = 1}, {.quantity = "force", .absolute = 0.1}}};
  EXPECT_FALSE(compare(a, b, {.tolerances = overruled}).agrees());
  EXPECT_FALSE(
      compare(a, b, {.tolerances = {1, {{.quantity = "*", .ignore = true}}}, .exact = true}).agrees());
}

TEST_F(CompareRuns, AnInfiniteDifferenceIsWithinNoTolerance) {
  const auto a = write("a", changedRow("penetration_depth", 10, std::numeric_limits<double>::infinity()));
  const auto b = write("b");
  const CompareSettings loose{.tolerances = {1, {{.quantity = "*", .relative = 1}}}};
  EXPECT_FALSE(compare(a, b, loose).agrees());
  EXPECT_FALSE(compare(b, a, loose).agrees());
}

TEST_F(CompareRuns, AShiftInTimeIsFoundAndMayBeTolerated) {
  const auto wave = [](double late) {
    return Changes{.row = [late](const RecordLayout& layout, std::size_t row, RecordRow& values) {
      values[layout.find("penetration_depth")->first_column] =
          std::sin(0.01 * (static_cast<double>(row) - late));
    }};
  };
  const auto a = write("a", wave(2)), b = write("b", wave(0));
  const RunComparison comparison = compare(a, b, {.max_shift_s = 3});
  const QuantityComparison& depth = find(comparison, "penetration_depth");
  EXPECT_FALSE(depth.agrees);
  ASSERT_TRUE(depth.shift);
  EXPECT_EQ(depth.shift_s, 1.0);  // two rows of 0.5 s
  EXPECT_LT(depth.shift->remaining, 1e-12);
  const auto agrees = [&](double shift_s) {
    const ToleranceRule rule{.quantity = "penetration_depth", .absolute = 1e-9, .time_shift_s = shift_s};
    return compare(a, b, {.tolerances = {1, {rule}}}).agrees();
  };
  EXPECT_TRUE(agrees(1));
  EXPECT_FALSE(agrees(0.5));
}

TEST_F(CompareRuns, AReferenceIsComparedAtItsOwnTimes) {
  const auto result = write("result"), reference = folder_ / "reference.h5";
  writeReference(reference, result);
  EXPECT_LT(std::filesystem::file_size(reference), std::filesystem::file_size(result) / 5);
  EXPECT_TRUE(readResultInfo(reference).reference);
  const RunComparison same = compare(result, reference, {.exact = true});
  EXPECT_TRUE(same.agrees());
  EXPECT_LE(find(same, "force").difference.rows, ReferenceSize().steps);
  // The last row is there.
  const auto end = write("end", changedRow("force", kRows - 1, 0.0));
  EXPECT_EQ(differing(compare(end, reference)), Names{"force"});
  EXPECT_EQ(find(compare(end, reference), "force").worst_at, "step 9999 (5 ks), hc, x");
  // Another time step, a shorter and a longer run are no match.
  EXPECT_FALSE(compare(write("short", {.rows = kRows - 1}), reference).agrees());
  EXPECT_FALSE(compare(write("long", {.rows = kRows + 1}), reference).agrees());
  const auto other_step =
      write("other", {.row = [](const RecordLayout& layout, std::size_t row, RecordRow& values) {
              values[layout.find("time")->first_column] = 0.4 * static_cast<double>(row);
            }});
  EXPECT_FALSE(compare(other_step, reference).agrees());
}

TEST_F(CompareRuns, AReferenceOfAFewStepsKeepsAll) {
  const auto result = write("result", {.rows = 3});
  writeReference(folder_ / "reference.h5", result);
  const RunComparison same = compare(result, folder_ / "reference.h5");
  EXPECT_TRUE(same.agrees());
  EXPECT_EQ(find(same, "force").difference.rows, 3u);
}

// Inputs of force laws are compared with a result; a reference has none, and misses none.
TEST_F(CompareRuns, InputsOfForceLawsAreComparedButNotWithReferences) {
  const auto asked = [](SampleRun& run) { run.scenario.record.force_inputs = true; };
  const auto changed = [](std::size_t row, State& seen) {
    if (row == 5) seen.law_inputs[3].rate_m_s += 1e-6;
  };
  const auto lacks = [](std::size_t row, State& seen) {
    if (row != 5) return;
    seen.colliding_triangles.pop_back();
    seen.law_inputs.resize(2);
  };
  const auto a = write("a", {.run = asked, .rows = 10});
  EXPECT_TRUE(compare(a, write("same", {.run = asked, .rows = 10}), {.exact = true}).agrees());
  const auto other = write("other", {.inputs = changed, .run = asked, .rows = 10});
  EXPECT_EQ(differing(compare(other, a)), Names{"force_inputs/deformation_rate"});
  EXPECT_EQ(find(compare(other, a), "force_inputs/deformation_rate").worst_at, "obs 5, linear");
  const Names different =
      differing(compare(write("lacking", {.inputs = lacks, .run = asked, .rows = 10}), a));
  EXPECT_NE(std::find(different.begin(), different.end(), "force_inputs/row_size"), different.end());
  EXPECT_NE(std::find(different.begin(), different.end(), "force_inputs/area"), different.end());
  EXPECT_FALSE(compare(write("without", {.rows = 10}), a).agrees());
  writeReference(folder_ / "reference.h5", a);
  EXPECT_TRUE(compare(a, folder_ / "reference.h5").agrees());
  EXPECT_TRUE(compare(other, folder_ / "reference.h5").agrees());
  for (const DatasetInfo& dataset : readResultInfo(folder_ / "reference.h5").datasets)
    EXPECT_EQ(dataset.path.find("force_inputs"), std::string::npos) << dataset.path;
}

TEST_F(CompareRuns, ADamagedFileIsAnInputError) {
  const auto a = write("a"), b = write("b");
  infos_ = {readResultInfo(a), readResultInfo(b)};
  std::filesystem::resize_file(b, std::filesystem::file_size(b) / 2);
  EXPECT_THROW(
      compareRuns({a, &infos_[0], &infos_[0].pipelines[0]}, {b, &infos_[1], &infos_[1].pipelines[0]}, {}),
      InputError);
}

}  // namespace
}  // namespace fissure::compare_runs_test
