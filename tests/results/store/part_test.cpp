#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "base/error.h"
#include "salvaged.h"
#include "store/force_inputs.h"
#include "store/part_file.h"

namespace fissure::part_test {

namespace {

std::size_t rowsOf(const std::filesystem::path& path) {
  return readSeries(path, "/pipelines/default/time").shape.at(0);
}

// The salvaged inputs of force laws end with the salvaged rows, each with its right values.
void expectSalvagedInputs(const ScratchFolder& folder, std::size_t rows) {
  const ForceInputs inputs = readForceInputs(folder / "salvaged.h5", "default");
  ASSERT_EQ(inputs.times_s.size(), rows);
  std::size_t at = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const State expected = sampleInputs(row);
    ASSERT_EQ(inputs.times_s[row], expected.time_s);
    ASSERT_EQ(inputs.row_sizes[row], expected.colliding_triangles.size());
    for (const LawInput& input : expected.law_inputs) {
      ASSERT_EQ(inputs.inputs[at].deformation_m, input.deformation_m) << row;
      ASSERT_EQ(inputs.inputs[at].rate_m_s, input.rate_m_s) << row;
      ASSERT_EQ(inputs.inputs[at].area_m2, input.area_m2) << row;
      ASSERT_EQ(inputs.inputs[at].direction, input.direction) << row;
      ++at;
    }
  }
  EXPECT_EQ(inputs.inputs.size(), at);
  EXPECT_EQ(inputs.laws, (std::vector<std::string>{"hc", "linear"}));
}

TEST(Part, FinishStoresStatusAndSummary) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(5, true);
  const auto path = folder / "default.part";
  const auto part = openSamplePart(path, run, "default");
  appendSamples(*part, run);
  part->finish({RunEnd::non_finite, "at step 5"}, {{"steps", 5LL}, {"timing/mean_us", 2.0}});
  const ResultInfo info = readResultInfo(path);
  EXPECT_FALSE(info.complete) << "a part is no result";
  EXPECT_EQ(info.format, "fissure-part");
  EXPECT_EQ(info.title, "sample");
  EXPECT_EQ(info.scenario_resolved, "name: sample\n") << "a part alone can be salvaged";
  EXPECT_EQ(nameOf(info.pipelines.at(0).status.end), "non_finite");
  EXPECT_EQ(info.pipelines.at(0).status.detail, "at step 5");
  ASSERT_EQ(info.pipelines.at(0).summary.size(), 2U);
  EXPECT_EQ(rowsOf(path), 5U);
  EXPECT_THROW(part->append(sampleRow(run.layout, 5)), std::logic_error);
}

TEST(Part, FinishWithoutAnyRowWorks) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(0, true);
  const auto path = folder / "default.part";
  writeSamplePart(path, run, "default");
  EXPECT_EQ(nameOf(statusOf(path).end), "ok");
  EXPECT_EQ(rowsOf(path), 0U);
}

TEST(Part, DroppedWithoutFinishIsIncompleteAndReadable) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(7, true);
  const auto path = folder / "default.part";
  appendSamples(*openSamplePart(path, run, "default"), run);
  EXPECT_EQ(nameOf(statusOf(path).end), "incomplete");
  EXPECT_EQ(salvagedRows(folder, run, path), 7U);
  EXPECT_EQ(readSeries(folder / "salvaged.h5", "/pipelines/default/frames").shape,
            (std::vector<std::size_t>{2, 4, 5, 3}));
}

// The worker is killed with 700 rows in the buffer behind two whole blocks of 3334: the blocks are there.
TEST(Part, KilledWriterLeavesItsCompleteBlocks) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(10000, false);
  const auto path = folder / "default.part";
  const ChildResult child = runInChild([&] {
    const auto part = openSamplePart(path, run, "default");
    for (std::size_t row = 0; row < 2 * 3334 + 700; ++row) part->append(sampleRow(run.layout, row));
    ::raise(SIGKILL);
    return 0;
  });
  EXPECT_FALSE(child.exited);
  EXPECT_EQ(child.code, SIGKILL);
  EXPECT_EQ(nameOf(statusOf(path).end), "incomplete");
  EXPECT_EQ(rowsOf(path), 2 * 3334U);
  EXPECT_EQ(salvagedRows(folder, run, path), 2 * 3334U);
}

// What the laws saw of a step whose row never came is cut.
TEST(Part, InputsOfForceLawsEndWithTheRowsThatCount) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(7, false);
  run.scenario.record.force_inputs = true;
  const auto path = folder / "default.part";
  {
    const auto part = openSamplePart(path, run, "default");
    appendSamples(*part, run);
    part->forceInputs(sampleInputs(8));
  }
  const std::string group = "/pipelines/default/force_inputs/";
  EXPECT_EQ(readSeries(path, group + "area").values.size(), 6U + 2U) << "nothing to cut, no test";
  EXPECT_EQ(salvagedRows(folder, run, path), 7U);
  expectSalvagedInputs(folder, 7);
  for (const char* name : {"obs", "triangle", "area"})
    EXPECT_EQ(readSeries(folder / "salvaged.h5", group + name).values.size(), 6U) << name;
}

TEST(Part, InputsOfForceLawsMustBeAskedForAndFit) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(3, false);
  EXPECT_THROW(openSamplePart(folder / "default.part", run, "default")->forceInputs(sampleInputs(1)),
               std::logic_error);
  run.scenario.record.force_inputs = true;
  State state = sampleInputs(2);
  state.law_inputs.pop_back();
  EXPECT_THROW(openSamplePart(folder / "default.part", run, "default")->forceInputs(state), std::logic_error);
}

// Killed from outside at any moment of its writing, in the middle of a flush too.
TEST(Part, WriterKilledAtAnyMomentLeavesWholeRows) {
  for (int trial = 0; trial < 25; ++trial) {
    const ScratchFolder folder;
    SampleRun run = makeSampleRun(100, true);
    run.scenario.record.force_inputs = true;
    const auto path = folder / "default.part";
    int begun[2];
    ASSERT_EQ(::pipe(begun), 0);
    const pid_t writer = ::fork();
    if (writer == 0) {
      const auto part = openSamplePart(path, run, "default");
      for (std::size_t row = 0;; ++row) {
        part->forceInputs(sampleInputs(row));
        part->append(sampleRow(run.layout, row));
        if (row == 100 && ::write(begun[1], "!", 1) != 1) ::_exit(1);
        if (row % 10 == 0) part->snapshot(sampleState(row / 10));
        if (row % 200 == 0) part->frame(2.0, sampleImage(1));
      }
    }
    // Wait for the first block, then for a moment that differs from trial to trial.
    ::close(begun[1]);
    char sign = 0;
    EXPECT_EQ(::read(begun[0], &sign, 1), 1);
    ::close(begun[0]);
    ::usleep(static_cast<useconds_t>(1733 * trial));
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    EXPECT_NO_THROW(inspectPart(path)) << "trial " << trial;
    const std::size_t rows = salvagedRows(folder, run, path);
    EXPECT_GE(rows, 100U);
    expectSalvagedInputs(folder, rows);
    const auto result = folder / "salvaged.h5";
    const SeriesData snapshots = readSeries(result, "/pipelines/default/snapshot_time");
    const SeriesData positions = readSeries(result, "/pipelines/default/positions");
    ASSERT_EQ(positions.shape[0], snapshots.values.size());
    for (std::size_t i = 0; i < snapshots.values.size(); ++i) {
      ASSERT_EQ(positions.values[i * 24], static_cast<double>(i)) << "trial " << trial;
    }
  }
}

// With no patience between blocks each row reaches the disk at once; with a long one none does before its
// block.
TEST(Part, OldBlockIsWrittenBeforeItIsFull) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(1000, false);
  for (const double flush_every_s : {0.0, 3600.0}) {
    const auto path = folder / "default.part";
    const auto part = createPartFile(path, {.scenario = run.scenario,
                                            .pipeline = run.scenario.pipelines.at(1),
                                            .scene = run.scene,
                                            .layout = run.layout,
                                            .expected_steps = static_cast<std::int64_t>(run.rows) - 1,
                                            .flush_every_s = flush_every_s});
    for (std::size_t row = 0; row < 3; ++row) part->append(sampleRow(run.layout, row));
    const ChildResult reader = runInChild([&] { return static_cast<int>(rowsOf(path)); });
    EXPECT_EQ(reader.code, flush_every_s == 0.0 ? 3 : 0) << reader.errors;
  }
}

// What is missing would otherwise become a hole of zeros under the next block.
TEST(Part, CutShortBySomebodyElseIsARunError) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(3000, true);
  const auto path = folder / "default.part";
  const auto part = openSamplePart(path, run, "default");
  appendSamples(*part, run);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  try {
    part->finish({RunEnd::ok, ""}, {});
    FAIL();
  } catch (const RunError& error) {
    EXPECT_EQ(error.what(), path.string() + ": cannot write: somebody else has cut the file short");
  }
}

TEST(Part, ReadersDoNotKeepItFromBeingFinished) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(100, false);
  const auto path = folder / "default.part";
  writeSamplePart(path, run, "default");
  const pid_t reader = ::fork();
  while (reader == 0) {
    try {
      readResultInfo(path);
    } catch (const InputError&) {  // just being begun
    }
  }
  for (int trial = 0; trial < 50; ++trial) {
    const auto part = openSamplePart(path, run, "default");
    appendSamples(*part, run);
    EXPECT_NO_THROW(part->finish({RunEnd::ok, ""}, {})) << "trial " << trial;
  }
  ::kill(reader, SIGKILL);
  ::waitpid(reader, nullptr, 0);
}

TEST(Salvage, SaysUpToWhichStep) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(1000, false);
  const auto path = folder / "default.part";
  {
    const auto part = openSamplePart(path, run, "default");
    for (std::size_t row = 0; row < 3; ++row) part->append(sampleRow(run.layout, row));
  }
  const PartContent content = inspectPart(path);
  EXPECT_EQ(content.pipeline, "default");
  EXPECT_EQ(nameOf(content.status.end), "salvaged");
  EXPECT_EQ(content.status.detail, "up to step 2 of 999 (t = 1 s), what came after was not on the disk yet");
  writeSamplePart(path, run, "default");
  EXPECT_EQ(nameOf(inspectPart(path).status.end), "ok") << "a finished run keeps its status";
}

TEST(Salvage, PartWithoutARowIsRefused) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(1000, false);
  openSamplePart(folder / "default.part", run, "default");
  EXPECT_THROW(inspectPart(folder / "default.part"), InputError);
}

TEST(Part, RefusesWhatDoesNotFit) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(5, false);
  const SampleRun with_pictures = makeSampleRun(5, true);
  const auto part = openSamplePart(folder / "a.part", run, "default");
  EXPECT_THROW(part->append(RecordRow(3)), std::logic_error);
  EXPECT_THROW(part->snapshot(sampleState(0)), std::logic_error) << "not asked for";
  EXPECT_THROW(part->frame(0, sampleImage(0)), std::logic_error) << "not asked for";
  const auto pictures = openSamplePart(folder / "b.part", with_pictures, "default");
  EXPECT_THROW(pictures->frame(0, Image{2, 2, std::vector<std::uint8_t>(12)}), std::logic_error);
  State state = sampleState(0);
  state.positions_m.pop_back();
  EXPECT_THROW(pictures->snapshot(state), std::logic_error);
  RecordRow row = sampleRow(run.layout, 0);
  row[run.layout.find("contact_count")->first_column] = std::numeric_limits<double>::quiet_NaN();
  part->append(row);
  EXPECT_THROW(part->finish({RunEnd::ok, ""}, {}), std::logic_error) << "a count cannot be missing";
}

TEST(Part, RefusesLayoutsWithoutTimeOrWithClashingNames) {
  const ScratchFolder folder;
  const auto open = [&](const RecordLayout& layout) {
    SampleRun run = makeSampleRun(5, false);
    run.layout = layout;
    openSamplePart(folder / "a.part", run, "default");
  };
  RecordLayout no_time;
  no_time.add({"depth", "m", "depth", ValueType::real, {}});
  EXPECT_THROW(open(no_time), std::logic_error);
  RecordLayout clash;
  clash.add({"time", "s", "time", ValueType::real, {}});
  clash.addAxis({"law", {"a"}});
  clash.add({"force", "N", "force", ValueType::real, {"law"}});
  clash.add({"law", "1", "a series called as an axis is", ValueType::real, {}});
  EXPECT_THROW(open(clash), std::logic_error);
  RecordLayout unknown_group;
  unknown_group.add({"time", "s", "time", ValueType::real, {}});
  unknown_group.add({"other/x", "m", "x", ValueType::real, {}});
  EXPECT_THROW(open(unknown_group), std::logic_error);
}

TEST(Part, SaysWhyItCannotBeMade) {
  const SampleRun run = makeSampleRun(5, false);
  try {
    openSamplePart("/nowhere/a.part", run, "default");
    FAIL();
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/a.part: cannot create: No such file or directory");
  }
}

}  // namespace
}  // namespace fissure::part_test
