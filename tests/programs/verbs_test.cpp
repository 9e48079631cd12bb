// The verbs that simulate nothing, and results as other tools see them.
#include <gtest/gtest.h>

#include <cstdint>

#include "program.h"
#include "scenario/catalog.h"
#include "scenarios.h"
#include "store/result_file.h"

namespace fissure::programs::verbs_test {
namespace {

TEST(Verbs, HelpAndVersionAreGood) {
  const Folder folder;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--help"},
                                                                                     {"run", "--help"},
                                                                                     {"plan", "--help"},
                                                                                     {"validate", "--help"},
                                                                                     {"list", "--help"},
                                                                                     {"info", "--help"},
                                                                                     {"salvage", "--help"},
                                                                                     {"export", "--help"},
                                                                                     {"fit", "--help"},
                                                                                     {"compare", "--help"},
                                                                                     {"report", "--help"},
                                                                                     {"--version"}}) {
    const Outcome outcome = runFissure(folder, words);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
  }
}

TEST(Verbs, WhatCannotBePrintedIsNoSuccess) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  for (const std::string words :
       {"--help", "--version", "list", "plan s.yaml", "validate s.yaml", "run s.yaml -o r.h5", "info r.h5"}) {
    const Outcome outcome = runTool(folder, {"sh", "-c", fissureProgram() + " " + words + " > /dev/full"});
    EXPECT_EQ(outcome.code, 3) << words;
    EXPECT_TRUE(outcome.err.ends_with("standard output: cannot write: No space left on device\n"))
        << words << outcome.err;
  }
  const Outcome worker = runTool(folder, {"sh", "-c", engineWorkerProgram() + " --help > /dev/full"});
  EXPECT_EQ(worker.code, 3);
  EXPECT_EQ(worker.err, "error: standard output: cannot write: No space left on device\n");
}

TEST(Verbs, ListNamesTheWholeCatalog) {
  const Folder folder;
  const std::string out = runFissure(folder, {"list"}).out;
  const Catalog& tables = catalog();
  for (const auto* table :
       {&tables.pipelines,    &tables.force_laws,     &tables.tissues,         &tables.body_shapes,
        &tables.tool_shapes,  &tables.clamp_openings, &tables.node_placements, &tables.motions,
        &tables.timings,      &tables.interpolations, &tables.settings,        &tables.precisions,
        &tables.responses,    &tables.log_layouts,    &tables.device_frames,   &tables.rates,
        &tables.deformations, &tables.aero_models,    &tables.soft_contacts,   &tables.ground_contacts})
    for (const CatalogEntry& entry : *table) {
      EXPECT_NE(out.find("  " + std::string(entry.name) + " "), std::string::npos) << entry.name;
      EXPECT_NE(out.find(entry.description), std::string::npos) << entry.name;
    }
}

// What the rules of a replay have found is shown before anything is run.
TEST(Verbs, PlanShowsWhatALogHolds) {
  const Outcome plan = runFissure(Folder(), {"plan", FISSURE_SOURCE_DIR "/configs/replay_falcon.yaml"});
  EXPECT_EQ(plan.code, 0) << plan.err;
  for (const char* count : {" samples, ", " held samples, ", " gaps, ", " jumps, ", " dropped rows, "})
    EXPECT_NE(plan.out.find(count), std::string::npos) << count << plan.out;
  EXPECT_NE(plan.out.find("replay: time in s, "), std::string::npos) << plan.out;
  const Folder folder;
  std::string text = pressScenario();
  const std::size_t from = text.find("      type: script\n"), to = text.find("pipelines:");
  folder.write("s.yaml",
               text.replace(from, to - from, "      {type: replay, file: a.csv, time_column: TIME_MS}\n"));
  folder.write("a.csv", "TIME_MS,x,y,z\n0,0,0.062,0\n20,0,0.052,0\n");
  EXPECT_NE(runFissure(folder, {"plan", "s.yaml"}).out.find("replay: time in ms, 2 samples"),
            std::string::npos);
}

// 0.03 s of 1 ms steps: 30 steps, snapshots at 0, 10, 20 and 30 ms, frames at 0 and 20 ms.
TEST(Verbs, PlanShowsStagesAndWritesNothing) {
  const Folder folder;
  folder.write(
      "s.yaml",
      pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.03",
                    "force: [{name: hc, model: hunt_crossley}]\n"
                    "record: {snapshots_every_s: 0.01, frames: {every_s: 0.02, size_px: [64, 48]}}\n"));
  const Outcome plan = runFissure(folder, {"plan", "s.yaml"});
  EXPECT_EQ(plan.code, 0) << plan.err;
  for (const char* text :
       {"30 steps of 0.001 s, 2 runs", "32 triangles, 18 vertices", "run default (default, f64",
        "settle: 5 steps", "simulate: 30 steps", "detect: 32 tool nodes", "hc (hunt_crossley)",
        "snapshots: 4;", "frames: 2 of 64 x 48 px; 18.4 kB", "penetration_depth", "result: about "})
    EXPECT_NE(plan.out.find(text), std::string::npos) << text << "\n" << plan.out;
  const Outcome fixed =
      runFissure(folder, {"plan", "s.yaml", "--set", "bodies.sphere.fixed=[{below_m: 0.01}]"});
  EXPECT_NE(fixed.out.find("32 triangles, 18 vertices, 5 of them fixed"), std::string::npos) << fixed.out;
  const Outcome bare = runFissure(folder, {"plan", "s.yaml", "--no-frames", "--pipeline", "default"});
  for (const char* text : {"frames", "detect", "fukuhara", "fixed"})
    EXPECT_EQ(bare.out.find(text), std::string::npos) << text << "\n" << bare.out;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.yaml"});
}

TEST(Verbs, InfoShowsDatasetsAndProvenance) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const std::string out = runFissure(folder, {"info", "out.h5"}).out;
  for (const char* text :
       {"press\n", "fissure-result, version 1", "command_line", "fissure run s.yaml -o out.h5",
        "/pipelines/fukuhara/penetration_depth", "f64", "31  m"})
    EXPECT_NE(out.find(text), std::string::npos) << text << "\n" << out;
}

TEST(OtherTools, XarrayReadsAPipeline) {
  const std::string python = pythonWith("xarray, h5netcdf");
  if (python.empty()) GTEST_SKIP() << "no python3 with xarray and h5netcdf here";
  const Folder folder;
  folder.write(
      "s.yaml",
      pressScenario("[{pipeline: fukuhara}]", "0.03",
                    "force: [{name: hc, model: hunt_crossley}]\nrecord: {snapshots_every_s: 0.01}\n"));
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const Outcome read = runTool(
      folder, {python, "-c",
               "import xarray\n"
               "data = xarray.open_dataset('out.h5', group='pipelines/fukuhara', engine='h5netcdf')\n"
               "assert data.penetration_depth.dims == ('time',), data\n"
               "assert data.sizes['time'] == 31 and abs(float(data.time[-1]) - 0.03) < 1e-12, data\n"
               "assert data.force.dims == ('law', 'time', 'xyz'), data.force\n"
               "assert data.positions.dims == ('snapshot_time', 'vertex', 'xyz'), data.positions\n"
               "assert data.positions.shape == (4, 18, 3) and bool(data.positions.notnull().all())\n"});
  EXPECT_EQ(read.code, 0) << read.err;
}

TEST(OtherTools, H5dumpReadsTheWholeFile) {
  const Folder folder;
  if (runTool(folder, {"h5dump", "--version"}).code != 0) GTEST_SKIP() << "no h5dump here";
  folder.write("s.yaml", pressScenario());
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const Outcome dump = runTool(folder, {"h5dump", "out.h5"});
  EXPECT_EQ(dump.code, 0) << dump.err;
  EXPECT_NE(dump.out.find("penetration_depth"), std::string::npos);
}

}  // namespace
}  // namespace fissure::programs::verbs_test
