#include "table/sweep_table.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "sample_sweep.h"
#include "store/sample_run.h"
#include "table/sweep_csv.h"
#include "table/sweep_names.h"
#include "table/sweep_table_writer.h"

namespace fissure::sweep_table_test {

namespace {

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::string complaint(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing";
}

/// A table of one axis, one metric and no curves, with these values.
SweepTableLayout smallLayout(std::size_t runs) {
  SweepTableLayout layout;
  layout.title = "small";
  layout.design = "random";
  layout.axes = {{"k", "force.hc.k", true}};
  layout.metrics = {{"max_force_N"}};
  layout.runs = runs;
  return layout;
}

bool sameNumber(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

TEST(SweepTable, RoundTripsEveryValue) {
  const ScratchFolder folder;
  const SweepTableLayout layout = sampleSweep(3000, 5);
  writeSampleSweep(folder / "sweep.h5", layout);
  const SweepTable table(folder / "sweep.h5");
  ASSERT_EQ(table.runs(), 3000U);
  EXPECT_TRUE(table.complete());
  EXPECT_EQ(table.layout().title, "sample");
  EXPECT_EQ(table.layout().description, layout.description);
  EXPECT_EQ(table.layout().design, "grid");
  EXPECT_EQ(table.layout().laws, layout.laws);
  EXPECT_EQ(table.layout().curve_time_s, layout.curve_time_s);
  EXPECT_EQ(table.layout().sweep_source, layout.sweep_source);
  EXPECT_EQ(table.layout().provenance, layout.provenance);
  ASSERT_EQ(table.layout().axes.size(), 3U);
  EXPECT_EQ(table.layout().axes[1].path, "force.hc.n");
  EXPECT_FALSE(table.layout().axes[2].numeric);
  ASSERT_EQ(table.layout().metrics.size(), 3U);
  EXPECT_EQ(table.layout().metrics[2].name, "timing/step_time_us");
  ASSERT_EQ(table.layout().curves.size(), 2U);
  EXPECT_TRUE(table.layout().curves[1].per_law);
  const std::vector<double> k = table.numbers("k"), time_us = table.numbers("timing/step_time_us");
  const std::vector<std::string> details = table.texts("status_detail");
  for (std::size_t run = 0; run < 3000; run += 37) {
    const SweepRun expected = sampleSweepRun(layout, run);
    EXPECT_EQ(k[run], std::stod(expected.values[0]));
    EXPECT_EQ(time_us[run], expected.metrics[2]);
    EXPECT_EQ(details[run], expected.detail);
    EXPECT_EQ(table.texts("file", run, 1).front(), expected.file);
    std::vector<double> curves = table.curves(layout.curves[0], run, 1);
    for (const double force : table.curves(layout.curves[1], run, 1)) curves.push_back(force);
    ASSERT_EQ(curves.size(), expected.curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i)
      EXPECT_TRUE(sameNumber(curves[i], expected.curves[i])) << run << " " << i;
  }
}

TEST(SweepTable, KeepsNumbersToTheLastBit) {
  const ScratchFolder folder;
  const std::vector<double> values = {
      std::numeric_limits<double>::quiet_NaN(), -0.0, 1.7976931348623157e308, 5e-324, 0.1,
      -std::numeric_limits<double>::infinity(), 1e22};
  SweepTableWriter writer(folder / "sweep.h5", smallLayout(values.size()));
  for (const double value : values) writer.append({0, 0, "p", RunEnd::ok, "", "", {"1e-3"}, {value}, {}});
  writer.finish(false);
  const SweepTable table(folder / "sweep.h5");
  EXPECT_FALSE(table.complete());
  const std::vector<double> read = table.numbers("max_force_N");
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_TRUE(sameNumber(read[i], values[i])) << i;
  writeSweepCsv(folder / "sweep.csv", table);
  EXPECT_EQ(textOf(folder / "sweep.csv"),
            "run,point,pipeline,repeat,k,status,status_detail,file,max_force_N\n"
            "0,0,p,0,0.001,ok,,,\n"
            "1,0,p,0,0.001,ok,,,-0\n"
            "2,0,p,0,0.001,ok,,,1.7976931348623157e+308\n"
            "3,0,p,0,0.001,ok,,,5e-324\n"
            "4,0,p,0,0.001,ok,,,0.1\n"
            "5,0,p,0,0.001,ok,,,-inf\n"
            "6,0,p,0,0.001,ok,,,1e+22\n");
}

TEST(SweepTable, CountsAreDigitsInCsv) {
  const ScratchFolder folder;
  SweepTableLayout layout = smallLayout(2);
  layout.metrics = {{"rays"}, {"max_force_N"}};
  SweepTableWriter writer(folder / "sweep.h5", layout);
  writer.append({100000, 2000000, "p", RunEnd::ok, "", "", {"1e5"}, {3e15, 1e5}, {}});
  writer.append({1, 0, "p", RunEnd::ok, "", "", {"1e5"}, {0.5, -0.0}, {}});
  writer.finish(true);
  writeSweepCsv(folder / "sweep.csv", SweepTable(folder / "sweep.h5"));
  EXPECT_EQ(textOf(folder / "sweep.csv"),
            "run,point,pipeline,repeat,k,status,status_detail,file,rays,max_force_N\n"
            "0,100000,p,2000000,1e+05,ok,,,3000000000000000,1e+05\n"
            "1,1,p,0,1e+05,ok,,,0.5,-0\n");
}

TEST(SweepTable, NumericAxesHaveTheUnitsOfTheirNames) {
  const ScratchFolder folder;
  SweepTableLayout layout = smallLayout(1);
  layout.axes = {{"stiffness_N_m", "tools.spatula.coupling.stiffness_N_m", true},
                 {"start_m", "tools.spatula.motion.start_m", false}};
  SweepTableWriter writer(folder / "sweep.h5", layout);
  writer.append({0, 0, "p", RunEnd::ok, "", "", {"3000", "[0, 0.062, 0]"}, {1}, {}});
  writer.finish(true);
  const std::string check = "/usr/bin/python3 -c \"import h5py; f = h5py.File('" +
                            (folder / "sweep.h5").string() +
                            "'); assert [f[n].attrs['units'] for n in ('stiffness_N_m', 'start_m')] == "
                            "['N m-1', '1']\"";
  EXPECT_EQ(std::system(check.c_str()), 0);
}

TEST(SweepTable, QuotesFieldsAsRfc4180Says) {
  EXPECT_EQ(csvField("plain text"), "plain text");
  EXPECT_EQ(csvField("a,b"), "\"a,b\"");
  EXPECT_EQ(csvField("say \"a\""), "\"say \"\"a\"\"\"");
  EXPECT_EQ(csvField("two\nlines"), "\"two\nlines\"");
}

void expectReadableWithPython(std::size_t runs, std::size_t times) {
  const ScratchFolder folder;
  writeSampleSweep(folder / "sweep.h5", sampleSweep(runs, times));
  writeSweepCsv(folder / "sweep.csv", SweepTable(folder / "sweep.h5"));
  const std::string command =
      "/usr/bin/python3 -B " FISSURE_SOURCE_DIR "/tests/results/table/read_sweep.py " +
      (folder / "sweep.h5").string() + " " + (folder / "sweep.csv").string() + " " + std::to_string(runs) +
      " " + std::to_string(times) + " " FISSURE_SOURCE_DIR "/scripts/examples";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(SweepTable, ReadsInXarrayAsTableAndCube) {
  expectReadableWithPython(40, 6);
}

TEST(SweepTable, ReadsInXarrayWithOneRunAndNoCurves) {
  expectReadableWithPython(1, 0);
}

TEST(SweepTable, ReadsInXarrayAcrossBlocks) {
  expectReadableWithPython(3000, 3);
}

/// What sweep_cube.py says about a table of these rows, as it ends well.
std::string cubeOf(const SweepTableLayout& layout, const std::vector<SweepRun>& rows) {
  const ScratchFolder folder;
  SweepTableWriter writer(folder / "sweep.h5", layout);
  for (const SweepRun& row : rows) writer.append(row);
  writer.finish(true);
  const std::string command = "cd " + folder.path().string() +
                              " && /usr/bin/python3 -B " FISSURE_SOURCE_DIR
                              "/scripts/examples/sweep_cube.py sweep.h5 max_force_N > said.txt 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return textOf(folder / "said.txt");
}

TEST(SweepTable, CubesOfFewRunsAreSentences) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cubeOf(smallLayout(1), {{0, 0, "p", RunEnd::ok, "", "", {"1"}, {0.25}, {}}}),
            "max_force_N in N over run: 1\nall runs: 0.25 at run = 0\n");
  EXPECT_EQ(cubeOf(smallLayout(2), {{0, 0, "p", RunEnd::ok, "", "", {"1"}, {none}, {}},
                                    {0, 0, "q", RunEnd::ok, "", "", {"1"}, {0.25}, {}}}),
            "max_force_N in N over pipeline: 2\np: no value\nq: 0.25 at the only point\n");
  SweepTableLayout bare = smallLayout(1);
  bare.metrics.clear();
  EXPECT_EQ(cubeOf(bare, {{0, 0, "p", RunEnd::failed, "", "", {"1"}, {}, {}}}),
            "sweep.h5: no run has ended well\n");
  EXPECT_EQ(cubeOf(bare, {{0, 0, "p", RunEnd::ok, "", "", {"1"}, {}, {}}}), "sweep.h5 has no max_force_N\n");
}

// With other provenance, and on another day.
TEST(SweepTable, SameRowsGiveTheSameData) {
  const ScratchFolder folder;
  SweepTableLayout layout = sampleSweep(1100, 3);
  writeSampleSweep(folder / "a.h5", layout);
  layout.provenance = {{"version", "0.1.0"}, {"command_line", "fissure sweep sample.yaml --shard 1/2"}};
  writeSampleSweep(folder / "b.h5", layout);
  const std::string command = "/usr/bin/python3 -B " FISSURE_SOURCE_DIR "/scripts/result_bits.py " +
                              (folder / "a.h5").string() + " " + (folder / "b.h5").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(SweepTable, LeavesOutCurvesPerLawWithoutLaws) {
  const ScratchFolder folder;
  SweepTableLayout layout = sampleSweep(1, 4);
  layout.laws.clear();
  SweepRun run = sampleSweepRun(layout, 0);
  run.curves.resize(4);
  SweepTableWriter writer(folder / "sweep.h5", layout);
  writer.append(run);
  writer.finish(true);
  EXPECT_EQ(SweepTable(folder / "sweep.h5").layout().curves.size(), 1U);
}

TEST(SweepTable, KeepsTheMeasuredCurve) {
  const ScratchFolder folder;
  SweepTableLayout layout = sampleSweep(2, 3);
  layout.measured_N = {0, 0.5, 0.25};
  writeSampleSweep(folder / "sweep.h5", layout);
  EXPECT_EQ(SweepTable(folder / "sweep.h5").layout().measured_N, layout.measured_N);
}

TEST(SweepTable, RefusesRowsThatDoNotFit) {
  const ScratchFolder folder;
  SweepTableWriter writer(folder / "sweep.h5", smallLayout(2));
  EXPECT_THROW(writer.append({0, 0, "p", RunEnd::ok, "", "", {"1"}, {}, {}}), std::logic_error);
  EXPECT_THROW(writer.append({0, 0, "p", RunEnd::ok, "", "", {"one"}, {1}, {}}), std::logic_error);
  EXPECT_THROW(writer.finish(true), std::logic_error);
  SweepTableLayout twice = smallLayout(1);
  twice.metrics.push_back({"k"});
  EXPECT_THROW(SweepTableWriter(folder / "other.h5", twice), std::logic_error);
}

TEST(SweepTable, StandsUnderItsNameOnlyWhenFinished) {
  const ScratchFolder folder;
  writeSampleSweep(folder / "sweep.h5", sampleSweep(3, 2));
  {
    SweepTableWriter dropped(folder / "sweep.h5", sampleSweep(5, 2));
    dropped.append(sampleSweepRun(sampleSweep(5, 2), 0));
  }
  EXPECT_EQ(SweepTable(folder / "sweep.h5").runs(), 3U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_EQ(complaint([] { SweepTableWriter("/nowhere/sweep.h5", sampleSweep(1, 1)); }),
            "/nowhere/sweep.h5: cannot create: No such file or directory");
}

TEST(FullDisk, SweepTableEitherWholeOrRunError) {
  const ScratchFolder folder;
  const auto path = folder / "sweep.h5";
  writeSampleSweep(path, sampleSweep(1500, 4));
  const auto whole = std::filesystem::file_size(path);
  writeSampleSweep(path, sampleSweep(2, 4));
  std::size_t failures = 0;
  for (rlim_t limit = 0; limit <= whole + 4096; limit += whole / 20) {
    const ChildResult child = runInChild([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limits{limit, limit};
      ::setrlimit(RLIMIT_FSIZE, &limits);
      const std::string said = complaint([&] { writeSampleSweep(path, sampleSweep(1500, 4)); });
      return said == "nothing" ? 0 : said == path.string() + ": cannot write: File too large" ? 42 : 43;
    });
    ASSERT_TRUE(child.exited) << "limit " << limit << ", signal " << child.code;
    EXPECT_EQ(child.errors, "") << "limit " << limit;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "limit " << limit;
    EXPECT_EQ(SweepTable(path).runs(), child.code == 0 ? 1500U : 2U) << "limit " << limit;
    if (child.code != 0) {
      EXPECT_EQ(child.code, 42) << "limit " << limit;
      ++failures;
    }
  }
  EXPECT_GT(failures, 15U) << "the limit did not bite";
}

TEST(SweepTable, SaysWhatIsWrongWithAFile) {
  const ScratchFolder folder;
  const auto path = folder / "sweep.h5";
  const auto said = [&] { return complaint([&] { SweepTable table(path); }); };
  EXPECT_EQ(said(), path.string() + ": no such file, expected a fissure sweep");
  std::ofstream(path) << "no HDF5";
  EXPECT_NE(said().find(": not an HDF5 file, expected a fissure sweep ("), std::string::npos) << said();
  const SampleRun run = makeSampleRun(3, false);
  writeSamplePart(folder / "p.part", run, "default");
  assembleResult(path, loadedSample(run), {}, {{run.scenario.pipelines.front(), folder / "p.part", {}}});
  EXPECT_EQ(
      said(),
      path.string() + ": an HDF5 file, but no fissure sweep (expected attribute format = \"fissure-sweep\")");
  EXPECT_FALSE(isSweepTable(path));
  writeSampleSweep(path, sampleSweep(3, 2));
  EXPECT_TRUE(isSweepTable(path));
  const std::string newer = "/usr/bin/python3 -c \"import h5py; h5py.File('" + path.string() +
                            "', 'r+').attrs['format_version'] = 2\"";
  ASSERT_EQ(std::system(newer.c_str()), 0);
  EXPECT_EQ(said(), path.string() + ": format_version 2, expected at most 1: written by a newer fissure");
  writeSampleSweep(path, sampleSweep(3, 2));
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_NE(said().find("a damaged or truncated HDF5 file ("), std::string::npos) << said();
}

TEST(SweepTable, RefusesAnUnknownStatus) {
  const ScratchFolder folder;
  const auto path = folder / "sweep.h5";
  writeSampleSweep(path, sampleSweep(5, 2));
  EXPECT_EQ(SweepTable(path).ends(),
            (std::vector<RunEnd>{RunEnd::ok, RunEnd::ok, RunEnd::ok, RunEnd::non_finite, RunEnd::ok}));
  const std::string melted =
      "/usr/bin/python3 -c \"import h5py; h5py.File('" + path.string() + "', 'r+')['status'][1] = 'melted'\"";
  ASSERT_EQ(std::system(melted.c_str()), 0);
  const SweepTable table(path);
  EXPECT_EQ(table.texts("status").at(1), "melted");
  const std::string said = complaint([&] { table.ends(); });
  EXPECT_EQ(said.find(path.string() + ": the status \"melted\" of a run is unknown, expected one of ok, "),
            0U)
      << said;
}

TEST(SweepNames, AreTheShortestEndsThatTellPathsApart) {
  const auto names = [](const std::vector<std::string>& paths) { return sweepAxisNames(paths, {"depth_m"}); };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names({"force.hc.k", "tools.spatula.motion.speed_m_s"}), (Names{"k", "speed_m_s"}));
  EXPECT_EQ(names({"force.hc.k", "force.kv.k", "force.hc.n"}), (Names{"hc_k", "kv_k", "n"}));
  EXPECT_EQ(names({"a.depth_m", "force.0", "settings.status"}),
            (Names{"a_depth_m", "force_0", "settings_status"}));
  EXPECT_EQ(names({"status", "x.left-arm.y", "z.left.arm.y"}),
            (Names{"axis_status", "x_left_arm_y", "z_left_arm_y"}));
}

}  // namespace
}  // namespace fissure::sweep_table_test
