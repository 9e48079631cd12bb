#include "sweep/sweep_state.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "sweep_text.h"

namespace fissure::sweep_state_test {

namespace {

namespace fs = std::filesystem;

const std::string scenario =
    "{format: 1, name: press, bodies: [{name: ball, shape: {type: sphere, radius_m: 0.03, subdivisions: 1}, "
    "mass_kg: 0.1}], time: {duration_s: 1}, pipelines: [{pipeline: default}]}";

class StateTest : public testing::Test {
 protected:
  StateTest() : folder_(fs::path(testing::TempDir()) / ("fissure_state_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    SweepManifest manifest;
    manifest.settings = sweepOf("axes: [{path: bodies.ball.mass_kg, values: [0.1, 0.2]}]\nrepeats: 3\n");
    manifest.scenario = scenario;
    manifest.engines = {{"f64", "fnv1a64:1"}};
    manifest.pipelines = {"default"};
    manifest.points = SweepPoints(manifest.settings);
    plan_.emplace(manifest, folder_);
  }
  ~StateTest() override { fs::remove_all(folder_); }

  TaskRecord recordOf(std::size_t task, RunEnd end, double depth_m, long long recorded_s = 0) const {
    TaskRecord record;
    record.task = plan_->tasks().at(task).id;
    record.status = {end, "at " + std::to_string(recorded_s)};
    record.numbers = encodeNumbers({{"depth_m", "x"}, 1, {depth_m, 7}, {1, 2, 3}, {}});
    record.recorded_s = recorded_s;
    record.timing["timing/worker_wall_s"] = 2.5;
    return record;
  }
  /// A journal of its own for each.
  void write(const TaskRecord& record) const {
    JournalWriter(journalFolder(folder_)).append(encodeRecord(record));
  }
  /// The same with another status in it, which must be as long.
  void writeWithStatus(const TaskRecord& record, const std::string& status) const {
    std::string bytes = encodeRecord(record);
    bytes.replace(bytes.find(nameOf(record.status.end)), status.size(), status);
    JournalWriter(journalFolder(folder_)).append(bytes);
  }
  SweepState state() const { return {*plan_, folder_}; }
  bool refused() const {
    try {
      state();
    } catch (const RunError&) {
      return true;
    }
    return false;
  }

  fs::path folder_;
  std::optional<SweepPlan> plan_;
};

TEST_F(StateTest, KnowsWhatIsFinishedAndReadsSingleValues) {
  ASSERT_EQ(plan_->tasks().size(), 6u);
  write(recordOf(1, RunEnd::ok, 0.25));
  write(recordOf(4, RunEnd::non_finite, 0.5));
  write(recordOf(5, RunEnd::crashed, 0));
  const SweepState now = state();
  EXPECT_EQ(now.unfinished(), (std::vector<std::size_t>{0, 2, 3, 5}));
  EXPECT_EQ(nameOf(now.task(0).status.end), "missing");
  EXPECT_EQ(nameOf(now.task(5).status.end), "crashed");
  EXPECT_EQ(now.task(1).wall_s, 2.5);
  const SweepState::Head head = now.head(1);
  EXPECT_EQ(head.numbers.names, (std::vector<std::string>{"depth_m", "x"}));
  EXPECT_EQ(now.numbers(1, head, head.numbers.values_at, 2), (std::vector<double>{0.25, 7}));
  EXPECT_EQ(now.numbers(1, head, head.numbers.curves_at + 8, 2), (std::vector<double>{2, 3}));
  EXPECT_THROW(now.numbers(1, head, head.numbers.curves_at, 4), RunError);
}

TEST_F(StateTest, WhatWasNeverTriedComesFirstAndThenTheOldestFailure) {
  write(recordOf(0, RunEnd::timeout, 0, 9));
  write(recordOf(2, RunEnd::crashed, 0, 7));
  write(recordOf(3, RunEnd::ok, 0.5, 1));
  EXPECT_EQ(state().unfinished(), (std::vector<std::size_t>{1, 4, 5, 2, 0}));
  write(recordOf(2, RunEnd::crashed, 0, 11));
  EXPECT_EQ(state().unfinished(), (std::vector<std::size_t>{1, 4, 5, 0, 2}));
  SweepState lost = state();
  lost.forget(0);  // its record says nothing any more
  EXPECT_EQ(lost.unfinished(), (std::vector<std::size_t>{0, 1, 4, 5, 2}));
}

TEST_F(StateTest, RecordsOfOneTaskMustAgree) {
  write(recordOf(0, RunEnd::ok, 0.25, 1));
  write(recordOf(0, RunEnd::ok, 0.25, 2));
  EXPECT_FALSE(refused());
  write(recordOf(0, RunEnd::ok, 0.26));
  EXPECT_TRUE(refused());
}

TEST_F(StateTest, RepeatsMustAgree) {
  write(recordOf(0, RunEnd::ok, 0.25));
  write(recordOf(3, RunEnd::ok, 0.5));  // another point
  EXPECT_FALSE(refused());
  write(recordOf(2, RunEnd::ok, 0.26));  // the second of three is not there yet
  EXPECT_TRUE(refused());
}

TEST_F(StateTest, WhatFinishedCountsAndElseTheLatestFailure) {
  for (const long long recorded_s : {7, 9, 3}) write(recordOf(0, RunEnd::timeout, 0, recorded_s));
  EXPECT_EQ(state().task(0).status.detail, "at 9");
  write(recordOf(0, RunEnd::ok, 0.25, 1));
  EXPECT_EQ(nameOf(state().task(0).status.end), "ok");
  EXPECT_EQ(state().unfinished().size(), 5u);
}

TEST_F(StateTest, RecordsOfOtherSweepsAreCounted) {
  TaskRecord other = recordOf(0, RunEnd::ok, 1);
  other.task = "0123456789abcdef";
  write(other);
  EXPECT_EQ(state().unplannedRecords(), 1u);
  EXPECT_EQ(state().unfinished().size(), 6u);
}

TEST_F(StateTest, AnUnknownStatusIsRefused) {
  writeWithStatus(recordOf(0, RunEnd::crashed, 0), "crashed");
  EXPECT_EQ(state().task(0).status.end, RunEnd::crashed);
  writeWithStatus(recordOf(1, RunEnd::crashed, 0), "drowned");
  try {
    state();
    FAIL() << "it was taken";
  } catch (const RunError& error) {
    const std::string said = error.what();
    EXPECT_EQ(said.find(journalFolder(folder_).string()), 0U) << said;
    EXPECT_NE(
        said.find("no record of a sweep: the status \"drowned\" of a run is unknown, expected one of ok,"),
        std::string::npos)
        << said;
  }
}

}  // namespace
}  // namespace fissure::sweep_state_test
