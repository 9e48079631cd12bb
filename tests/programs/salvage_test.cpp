// What a killed run had brought to the disk becomes a result; everything else is one line.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>

#include "base/error.h"
#include "program.h"
#include "scenarios.h"
#include "store/read_series.h"
#include "store/result_file.h"

namespace fissure::programs::salvage_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// Two blocks of 2101 rows.
const std::string long_scenario = pressScenario(
    "[{pipeline: fukuhara}]", "4.2",
    "force: [{name: hc, model: hunt_crossley}]\nrecord: {snapshots_every_s: 0.01, force_inputs: true}\n");

/// Rows of a part that have their time; 0 when it cannot be read at this moment.
std::size_t rowsOf(const fs::path& part) {
  try {
    const std::vector<double> times_s = readSeries(part, "/pipelines/fukuhara/time").values;
    return times_s.empty() || std::isnan(times_s.back()) ? 0 : times_s.size();
  } catch (const InputError&) {
    return 0;
  }
}

/// The part of `run` as soon as a block of rows is in it; "" when the run ends before.
fs::path partWithABlock(const Folder& folder, const Program& run) {
  const pid_t worker = run.waitForWorker();
  while (!endsSoon(worker, 0.005))
    for (const std::string& name : folder.names())
      if (rowsOf(folder / name / "0.part") > 0) return folder / name / "0.part";
  return {};
}

std::string only(const Names& names, const std::string& beginning) {
  for (const std::string& name : names)
    if (name.starts_with(beginning)) return name;
  return "";
}

/// Of the run under way into out.h5.
fs::path folderOfParts(const Folder& folder) {
  for (const std::string& name : folder.names())
    if (name.starts_with(".out.h5.") && name != ".out.h5.lock") return folder / name;
  return {};
}

void expectRefused(const Folder& folder, const std::vector<std::string>& words, const std::string& fragment) {
  const Outcome outcome = runFissure(folder, words);
  EXPECT_EQ(outcome.code, 2) << fragment;
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_NE(outcome.err.find(fragment), std::string::npos) << outcome.err << "expected: " << fragment;
}

/// The salvaged file is the beginning of an undisturbed run, and says how far it goes.
void expectBeginning(const Folder& folder, const std::string& salvaged) {
  const ResultInfo info = readResultInfo(folder / salvaged);
  EXPECT_TRUE(info.complete && info.salvaged);
  EXPECT_EQ(info.format, "fissure-result");
  ASSERT_EQ(info.pipelines.size(), 1u);
  const RunStatus& status = info.pipelines[0].status;
  EXPECT_EQ(nameOf(status.end), "salvaged");
  const std::string place = "/pipelines/fukuhara/";
  const std::size_t rows = readSeries(folder / salvaged, place + "time").values.size();
  ASSERT_GT(rows, 1u);  // a block, or what ten seconds brought where that takes longer
  ASSERT_LE(rows, 4201u);
  EXPECT_TRUE(status.detail.starts_with("up to step " + std::to_string(rows - 1) + " of 4200 (t = "))
      << status.detail;
  folder.write("again.yaml", info.scenario_resolved);
  const std::string duration = std::to_string(static_cast<double>(rows - 1) * 0.001);
  ASSERT_EQ(runFissure(folder, {"run", "again.yaml", "-o", "whole.h5", "--force", "--set",
                                "time.duration_s=" + duration})
                .code,
            0);
  for (const char* name : {"time", "penetration_depth", "contact_count", "force"})
    EXPECT_EQ(readSeries(folder / salvaged, place + name).values,
              readSeries(folder / "whole.h5", place + name).values)
        << name;
  const std::size_t snapshots = readSeries(folder / salvaged, place + "snapshot_time").values.size();
  const SeriesData some = readSeries(folder / salvaged, place + "positions");
  const SeriesData all = readSeries(folder / "whole.h5", place + "positions");
  ASSERT_EQ(some.shape[0], snapshots);
  EXPECT_LE(some.values.size(), all.values.size());
  EXPECT_TRUE(std::equal(some.values.begin(), some.values.end(), all.values.begin()));
}

TEST(Salvage, PartOfAKilledFront) {
  const Folder folder;
  folder.write("s.yaml", long_scenario);
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  const fs::path part = partWithABlock(folder, run);
  ASSERT_FALSE(part.empty());
  const pid_t worker = run.waitForWorker();
  run.send(SIGKILL);
  run.wait();
  EXPECT_TRUE(endsSoon(worker));
  const std::string name = (part.parent_path().filename() / "0.part").string();
  const Outcome salvaged = runFissure(folder, {"salvage", name});
  ASSERT_EQ(salvaged.code, 0) << salvaged.err;
  EXPECT_NE(salvaged.out.find("fukuhara: salvaged: up to step "), std::string::npos) << salvaged.out;
  EXPECT_NE(salvaged.out.find("result: out/press.fukuhara.salvaged.h5\n"), std::string::npos);
  expectBeginning(folder, "out/press.fukuhara.salvaged.h5");
  const std::string shown = runFissure(folder, {"info", "out/press.fukuhara.salvaged.h5"}).out;
  EXPECT_NE(shown.find("fissure-result, version 1, salvaged from a run that did not finish\n"),
            std::string::npos)
      << shown;
  // Salvaging under the run's own name removes no part; the next run does.
  EXPECT_EQ(runFissure(folder, {"salvage", name, "-o", "out.h5"}).code, 0);
  EXPECT_TRUE(fs::exists(part));
  expectRefused(folder, {"salvage", name, "-o", "out.h5"},
                "out.h5: exists already, expected a new name or --force");
  EXPECT_EQ(runFissure(folder, {"salvage", name, "-o", "out.h5", "--force"}).code, 0);
  EXPECT_EQ(
      runFissure(folder, {"run", "s.yaml", "-o", "out.h5", "--force", "--set", "time.duration_s=0.01"}).code,
      0);
  EXPECT_EQ(only(folder.names(), "."), "") << "parts and lock are gone";
}

TEST(Salvage, KeptPartOfAKilledWorker) {
  const Folder folder;
  folder.write("s.yaml", long_scenario);
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5", "--keep-parts", "--json"});
  ASSERT_FALSE(partWithABlock(folder, run).empty());
  ::kill(run.waitForWorker(), SIGKILL);
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("kept_parts"), nlohmann::json({"out.h5.fukuhara.part"}));
  EXPECT_EQ(folder.names(), (Names{"out.h5", "out.h5.fukuhara.part", "s.yaml"}));
  EXPECT_EQ(nameOf(readResultInfo(folder / "out.h5").pipelines.at(0).status.end), "crashed");
  EXPECT_EQ(runFissure(folder, {"salvage", "out.h5.fukuhara.part", "-o", "salvaged.h5"}).code, 0);
  expectBeginning(folder, "salvaged.h5");
  expectRefused(folder, {"salvage", "out.h5.fukuhara.part", "-o", "out.h5.fukuhara.part", "--force"},
                "out.h5.fukuhara.part: is the part itself");
  // A later attempt that succeeds needs the part no more.
  EXPECT_EQ(
      runFissure(folder, {"run", "s.yaml", "-o", "out.h5", "--force", "--set", "time.duration_s=0.01"}).code,
      0);
  EXPECT_FALSE(fs::exists(folder / "out.h5.fukuhara.part"));
}

TEST(Salvage, StoppedRunKeepsItsPartOnRequestOnly) {
  const Folder folder;
  folder.write("s.yaml", long_scenario);
  for (const bool keep : {false, true}) {
    std::vector<std::string> words = {fissureProgram(), "run", "s.yaml", "-o", "out.h5"};
    if (keep) words.push_back("--keep-parts");
    Program run(folder, words);
    ASSERT_FALSE(partWithABlock(folder, run).empty());
    run.send(SIGTERM);
    const Outcome outcome = run.wait();
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(outcome.out.find("part: out.h5.fukuhara.part (for fissure salvage)\n") != std::string::npos,
              keep);
    EXPECT_EQ(folder.names(), keep ? (Names{"out.h5.fukuhara.part", "s.yaml"}) : Names{"s.yaml"});
  }
  expectRefused(folder, {"run", "s.yaml", "-o", "out.h5", "--keep-parts"},
                "out.h5.fukuhara.part: kept by an earlier run");
  EXPECT_EQ(runFissure(folder, {"salvage", "out.h5.fukuhara.part", "-o", "salvaged.h5"}).code, 0);
}

TEST(Salvage, WhatCouldNotBeKeptIsSaid) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{name: a, pipeline: fukuhara}, {name: b, pipeline: fukuhara}]"));
  folder.write("fissure-engine-f64",
               "#!/bin/sh\n"
               "while [ \"$1\" != --part ]; do shift; done\n"
               "case $2 in *0.part) exit;; *) echo noise > \"$2\"; esac\n");
  fs::permissions(folder / "fissure-engine-f64", fs::perms::owner_all);
  for (const bool keep : {false, true}) {
    std::vector<std::string> words = {"env",
                                      "FISSURE_ENGINE_DIR=" + folder.path().string(),
                                      fissureProgram(),
                                      "run",
                                      "s.yaml",
                                      "-o",
                                      "out.h5",
                                      "--force"};
    if (keep) words.push_back("--keep-parts");
    const Outcome outcome = runTool(folder, words);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out.starts_with("no part kept of a: nothing was written\n"
                                      "no part kept of b: not an HDF5 file"),
              keep)
        << outcome.out;
    EXPECT_EQ(outcome.out.find("no part kept") != std::string::npos, keep) << outcome.out;
    EXPECT_EQ(folder.names(), (Names{"fissure-engine-f64", "out.h5", "s.yaml"}));
  }
}

// A part whose log is gone: its scenario is read without it.
TEST(Salvage, NeedsNoneOfTheInputs) {
  const Folder folder;
  const std::string script =
      "type: script\n      start_m: [0, 0.062, 0]\n      segments:\n        - {move_to_m: [0, 0.052, 0], "
      "speed_m_s: 0.5}\n";
  folder.write("s.yaml", with(long_scenario, script,
                              "{type: replay, file: log.csv, time_column: t, position_columns: [x, y, z], "
                              "position_unit: m}\n"));
  folder.write("log.csv", "t,x,y,z\n0,0,0.062,0\n0.02,0,0.052,0\n4.2,0,0.052,0\n");
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  const fs::path part = partWithABlock(folder, run);
  ASSERT_FALSE(part.empty());
  run.send(SIGKILL);
  run.wait();
  fs::rename(part, folder / "a.part");
  fs::remove(folder / "s.yaml");
  fs::remove(folder / "log.csv");
  const Outcome salvaged = runFissure(folder, {"salvage", "a.part", "-o", "salvaged.h5"});
  EXPECT_EQ(salvaged.code, 0) << salvaged.err;
}

TEST(Salvage, RefusesWhatItCannotUse) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario());
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  ASSERT_GT(run.waitForWorker(), 0);
  const fs::path part = folderOfParts(folder) / "0.part";
  while (!fs::exists(part) && !endsSoon(run.process(), 0.005)) {
  }
  ASSERT_TRUE(fs::exists(part));
  run.send(SIGKILL);
  run.wait();
  folder.write("text.part", "no part\n");
  folder.write("empty.part", "");
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "whole.h5", "--set", "time.duration_s=0.01"}).code, 0);
  expectRefused(folder, {"salvage", fs::relative(part, folder.path()).string()}, "0.part: ");
  expectRefused(folder, {"salvage", "none.part"}, "none.part: no such file");
  expectRefused(folder, {"salvage", "."}, ".: is a folder, expected a fissure result");
  expectRefused(folder, {"salvage", "text.part"}, "text.part: not an HDF5 file");
  expectRefused(folder, {"salvage", "empty.part"}, "empty.part: not an HDF5 file");
  expectRefused(folder, {"salvage", "whole.h5"}, "whole.h5: a result, expected the part file of one run");
  expectRefused(folder, {"salvage"}, "PART is required");
  expectRefused(folder, {"salvage", ""}, "PART: names no file");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

/// Of a front that was killed after its first block of rows.
std::string partOfAKilledRun() {
  const Folder folder;
  folder.write("s.yaml", long_scenario);
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  const fs::path part = partWithABlock(folder, run);
  run.send(SIGKILL);
  run.wait();
  return part.empty() ? "" : folder.read(fs::relative(part, folder.path()).string());
}

/// A result or one line, never a crash, and an end; nothing else is left. True for a result.
bool salvagedInPeace(const std::string& damaged, const std::string& what) {
  const Folder folder;
  folder.write("a.part", damaged);
  const Outcome outcome = runFissure(folder, {"salvage", "a.part", "-o", "salvaged.h5"});
  EXPECT_TRUE(outcome.code == 0 || (outcome.code == 2 && isOneLine(outcome.err)))
      << what << ": exit " << outcome.code << ", signal " << outcome.signal << ", " << outcome.err;
  EXPECT_EQ(folder.names(), outcome.code == 0 ? (Names{"a.part", "salvaged.h5"}) : Names{"a.part"}) << what;
  if (outcome.code == 0) {
    EXPECT_TRUE(readResultInfo(folder / "salvaged.h5").complete) << what;
  }
  return outcome.code == 0;
}

// HDF5 1.10 alone loops for ever on some.
TEST(Salvage, CutPartsAreAResultOrOneLine) {
  const std::string whole = partOfAKilledRun();
  ASSERT_GT(whole.size(), 24000u);
  int refused = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const std::size_t size = i < 8 ? i * 3000 : whole.size() / 4 * (i - 8);
    refused += !salvagedInPeace(whole.substr(0, size), "cut to " + std::to_string(size));
  }
  EXPECT_GT(refused, 5) << "the damage did not bite";
}

// HDF5 1.10 alone crashes while it opens or copies some.
TEST(Salvage, OverwrittenPartsAreAResultOrOneLine) {
  const std::string whole = partOfAKilledRun();
  ASSERT_GT(whole.size(), 24000u);
  std::mt19937 random(3);
  int refused = 0;
  for (int i = 0; i < 24; ++i) {
    // The structures lie in front.
    const std::size_t at = i == 0 ? 18000 : random() % (i % 4 == 3 ? whole.size() - 64 : 24000);
    std::string damaged = whole;
    damaged.replace(at, 64, 64, i % 2 == 0 ? '\xff' : '\0');
    refused += !salvagedInPeace(damaged, "overwritten at " + std::to_string(at));
  }
  EXPECT_GT(refused, 3) << "the damage did not bite";
}

TEST(Salvage, XarrayReadsIt) {
  const std::string python = pythonWith("xarray, h5netcdf");
  if (python.empty()) GTEST_SKIP() << "no python3 with xarray and h5netcdf here";
  const Folder folder;
  folder.write("a.part", partOfAKilledRun());
  ASSERT_EQ(runFissure(folder, {"salvage", "a.part", "-o", "salvaged.h5"}).code, 0);
  const Outcome read =
      runTool(folder, {python, "-c",
                       "import xarray\n"
                       "data = xarray.open_dataset('salvaged.h5', group='pipelines/fukuhara')\n"
                       "assert data.attrs['status'] == 'salvaged', data\n"
                       "rows = data.sizes['time']\n"
                       "assert rows > 1 and abs(float(data.time[-1]) - 0.001 * (rows - 1)) < 1e-12, data\n"
                       "assert data.penetration_depth.dims == ('time',), data\n"
                       "assert data.force.dims == ('law', 'time', 'xyz'), data.force\n"
                       "assert data.positions.dims == ('snapshot_time', 'vertex', 'xyz'), data.positions\n"
                       "assert bool(data.positions.notnull().all()) and bool(data.time.notnull().all())\n"
                       "assert xarray.open_dataset('salvaged.h5').attrs['salvaged'] == 1\n"});
  EXPECT_EQ(read.code, 0) << read.err;
}

}  // namespace
}  // namespace fissure::programs::salvage_test
