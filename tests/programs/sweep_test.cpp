// Sweeps from outside: what a row says, what is computed once, what is bad input.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "program.h"
#include "scenarios.h"
#include "store/result_file.h"
#include "sweeps.h"
#include "table/sweep_table.h"

namespace fissure::programs::sweep_test {
namespace {

namespace fs = std::filesystem;

TEST(Sweep, EveryRowIsWhatARunOfItsPointGives) {
  const Folder folder;
  folder.write("press.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.03", laws));
  folder.write("s.yaml", sweepOf(speed_and_laws + curves));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out", "-j", "2"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  // Two speeds, two pipelines; eight sets of laws each.
  EXPECT_NE(outcome.out.find("16 points x 2 pipelines = 32 runs in 4 simulations"), std::string::npos)
      << outcome.out;
  const SweepTable table(folder / "out/sweep.h5");
  ASSERT_EQ(table.runs(), 32u);
  EXPECT_TRUE(table.complete());
  const CurveQuantity& force = table.layout().curves.front();
  ASSERT_EQ(force.name, "force");
  for (const std::size_t row : {0u, 7u, 18u, 31u}) {
    std::vector<std::string> words = {"run", "press.yaml", "-o", "one.h5", "--force"};
    for (const SweepAxisColumn& axis : table.layout().axes) {
      words.emplace_back("--set");
      words.push_back(axis.path + "=" + std::to_string(table.numbers(axis.name, row, 1).front()));
    }
    const std::string pipeline = table.texts("pipeline", row, 1).front();
    words.insert(words.end(), {"--pipeline", pipeline});
    ASSERT_EQ(runFissure(folder, words).code, 0);
    const std::map<std::string, double> summary = summaryOf(folder / "one.h5");
    EXPECT_GT(summary.at("max_force_N"), 0) << pipeline;
    for (const char* name : {"max_penetration_depth_m", "max_force_N", "max_force_hc_N", "max_force_linear_N",
                             "force_roughness_hc", "first_contact_time_s"}) {
      const double expected = summary.at(name);
      EXPECT_NEAR(table.numbers(name, row, 1).front(), expected, 1e-12 * std::abs(expected)) << name << row;
    }
    const std::vector<double> stored = table.curves(force, row, 1);
    const std::vector<double> expected = forceCurve(folder / "one.h5", pipeline, table.layout().curve_time_s);
    ASSERT_EQ(stored.size(), expected.size());
    for (std::size_t i = 0; i < stored.size(); ++i) {
      ASSERT_EQ(std::isnan(stored[i]), std::isnan(expected[i])) << i;  // after the run's end
      if (std::isnan(expected[i])) continue;
      EXPECT_NEAR(stored[i], expected[i], 1e-12 * std::abs(expected[i]) + 1e-15) << i;
    }
  }
}

// What a clamp feels of a law is not known to laws that share a simulation; it must not be another law's.
TEST(Sweep, NoNumberOfARowIsThatOfAnotherLaw) {
  const Folder folder;
  folder.write("press.yaml", fullScenario("[{pipeline: fukuhara}]"));
  folder.write(
      "s.yaml",
      sweepOf("axes: [{path: force.hc.k, values: [150, 333.25]}, {path: force.kv.c, values: [3]}]\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("= 2 runs in 1 simulation\n"), std::string::npos) << outcome.out;
  ASSERT_EQ(runFissure(folder, {"run", "press.yaml", "-o", "one.h5", "--no-frames", "--set",
                                "force.hc.k=333.25", "--set", "force.kv.c=3"})
                .code,
            0);
  const SweepTable table(folder / "out/sweep.h5");
  const std::map<std::string, double> summary = summaryOf(folder / "one.h5");
  std::size_t compared = 0, missing = 0;
  for (const SweepMetric& metric : table.layout().metrics) {
    if (metric.name.starts_with("timing/") || !summary.contains(metric.name)) continue;
    const double found = table.numbers(metric.name, 1, 1).front(), expected = summary.at(metric.name);
    if (std::isnan(found)) {
      ++missing;
      continue;
    }
    EXPECT_NEAR(found, expected, 1e-12 * std::abs(expected)) << metric.name;
    ++compared;
  }
  EXPECT_GT(compared, 30u);
  EXPECT_LT(missing, 30u);
  for (const char* name : {"max_force_hc_N", "max_force_kv_N", "force_roughness_area"})
    EXPECT_NEAR(table.numbers(name, 1, 1).front(), summary.at(name), 1e-12 * summary.at(name)) << name;
}

TEST(Sweep, SettingsOfOneEntryDoNotRunTheOthersAgain) {
  const Folder folder;
  folder.write("press.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]"));
  folder.write("s.yaml", sweepOf("axes: [{path: pipelines.fukuhara.sweeps, values: [1, 2, 3]},\n"
                                 "  {path: pipelines.1.max_displacement_m, values: [0.001, 0.002]}]\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("= 12 runs in 7 simulations"), std::string::npos) << outcome.out;
}

TEST(Sweep, LawsThatMoveAToolAreSimulated) {
  const Folder folder;
  std::string scenario = pressScenario("[{pipeline: fukuhara}]", "0.02", laws);
  scenario = with(scenario, "    motion:\n",
                  "    coupling: {mass_kg: 0.05, stiffness_N_m: 3000, damping_N_s_m: 20, force: hc}\n"
                  "    motion:\n");
  folder.write("press.yaml", scenario);
  folder.write("s.yaml", sweepOf("axes: [{path: force.hc.k, values: [100, 200]}]\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("= 2 runs in 2 simulations"), std::string::npos) << outcome.out;
}

TEST(Sweep, KeptResultsAreThoseOfARun) {
  const Folder folder;
  folder.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "0.02", laws));
  folder.write("s.yaml",
               sweepOf("axes: [{path: bodies.sphere.mass_kg, values: [0.1, 0.12]}]\nkeep: results\n"));
  ASSERT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out"}).code, 0);
  const SweepTable table(folder / "out/sweep.h5");
  const std::string file = table.texts("file").at(1);
  ASSERT_FALSE(file.empty());
  ASSERT_EQ(
      runFissure(folder, {"run", "press.yaml", "-o", "one.h5", "--set", "bodies.sphere.mass_kg=0.12"}).code,
      0);
  const ResultInfo kept = readResultInfo(folder / "out" / file);
  EXPECT_TRUE(kept.complete);
  EXPECT_EQ(kept.scenario_resolved, readResultInfo(folder / "one.h5").scenario_resolved);
  EXPECT_EQ(textsOf(folder / "out" / file).at("final_state_hash"),
            textsOf(folder / "one.h5").at("final_state_hash"));
}

TEST(Sweep, RunsAreHeldAgainstAMeasuredCurve) {
  const Folder folder;
  folder.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03", laws));
  folder.write("s.yaml", sweepOf("axes: [{path: force.hc.k, values: [100, 300, 200]}]\n"
                                 "curves: {quantities: [force, indentation], every_s: 0.001}\n"
                                 "fit: {curve: measured.csv, match: time, free_offset: false}\n"));
  folder.write("measured.csv", "time_s,force_N\n");
  EXPECT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out"}).code, 2);
  folder.write("measured.csv", "time_s,force_N\n0.01,1\n5,2\n");
  const Outcome late = runFissure(folder, {"sweep", "s.yaml", "-o", "late"});
  EXPECT_EQ(late.code, 0);
  EXPECT_NE(late.err.find("no run reaches all points of measured.csv, misfit_N is empty: "),
            std::string::npos)
      << late.err;
  ASSERT_EQ(runFissure(folder, {"run", "press.yaml", "-o", "one.h5"}).code, 0);  // k = 200
  std::string measured = "time_s,force_N\n";
  const std::vector<double> force_N = forceCurve(folder / "one.h5", "fukuhara", {0.01, 0.02, 0.03});
  for (int i = 0; i < 3; ++i)
    measured += std::to_string(0.01 * (i + 1)) + "," + std::to_string(force_N[i]) + "\n";
  folder.write("measured.csv", measured);
  const Outcome swept = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  ASSERT_EQ(swept.code, 0);
  EXPECT_EQ(swept.err.find("no run reaches"), std::string::npos) << swept.err;
  fs::remove(folder / "measured.csv");  // the plan has it
  ASSERT_EQ(runFissure(folder, {"sweep", "merge", "out"}).code, 0);
  const SweepTable table(folder / "out/sweep.h5");
  const std::vector<double> misfit_N = table.numbers("misfit_N");
  EXPECT_LT(misfit_N[2], 1e-5);
  EXPECT_GT(misfit_N[0], 0.01);
  EXPECT_GT(misfit_N[1], misfit_N[2]);
  EXPECT_EQ(table.layout().measured_N.size(), table.layout().curve_time_s.size());
}

TEST(Sweep, WhatFailsIsARowAndTheOthersGoOn) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf("axes: [{path: time.duration_s, values: [0.01, 1000]}]\n"
                                 "limits: {time_s: 3}\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out", "-j", "2"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(hasMatch(outcome.err, "first failure: [0-9a-f]{16}: timeout \\(time limit of 3 s"))
      << outcome.err;
  const SweepTable table(folder / "out/sweep.h5");
  EXPECT_EQ(table.texts("status"), (std::vector<std::string>{"ok", "timeout"}));
  EXPECT_TRUE(table.complete());
  EXPECT_FALSE(std::isnan(table.numbers("max_penetration_depth_m").at(0)));
  EXPECT_TRUE(std::isnan(table.numbers("max_penetration_depth_m").at(1)));
  // What failed is tried again, and nothing else; that it fails again gets nobody further.
  const Outcome again = runFissure(folder, {"sweep", "out", "--shard", "1/1", "--json"});
  EXPECT_EQ(again.code, 3);
  EXPECT_NE(again.err.find("to do: 1 of 2 simulations"), std::string::npos) << again.err;
  EXPECT_NE(again.out.find("\"failed\": 1,\n  \"interrupted\": 0,\n  \"advanced\": 0\n"), std::string::npos)
      << again.out;
}

TEST(Sweep, SimulationsThatTakeTooLongWaitForTheOthersTheNextTime) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf("axes: [{path: time.duration_s, values: [1000, 0.01]}]\n"
                                 "limits: {time_s: 2}\n"));
  ASSERT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out", "--fail-fast"}).code, 3);
  const Outcome next = runFissure(folder, {"sweep", "out", "--fail-fast", "--shard", "1/1"});
  EXPECT_EQ(next.code, 3);
  EXPECT_NE(runFissure(folder, {"sweep", "status", "out"}).out.find("1 ok, 1 timeout"), std::string::npos);
}

TEST(Sweep, StopsAtTheFirstFailureWhenAsked) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf("axes: [{path: time.duration_s, values: [1000, 0.01, 0.011, 0.012]}]\n"
                                 "limits: {time_s: 0.3}\n"));
  EXPECT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out", "--fail-fast"}).code, 3);
  const Outcome status = runFissure(folder, {"sweep", "status", "out"});
  EXPECT_NE(status.out.find("3 missing, 1 timeout"), std::string::npos) << status.out;
}

#ifndef __SANITIZE_ADDRESS__  // which takes terabytes of address space
TEST(Sweep, ASimulationBeyondItsMemoryFails) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf("axes: [{path: bodies.sphere.shape.subdivisions, values: [1, 7]}]\n"
                                 "limits: {memory_mb: 40}\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  EXPECT_EQ(outcome.code, 3) << outcome.out;
  const SweepTable table(folder / "out/sweep.h5");
  EXPECT_EQ(table.texts("status").at(0), "ok");
  EXPECT_NE(table.texts("status").at(1), "ok");  // libraries crash where we would say that it is too much
  EXPECT_NE(table.texts("status_detail").at(1).find("its memory is limited to 40 MiB"), std::string::npos);
}
#endif

TEST(Sweep, RepeatsAreRunAndMustAgree) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf("axes: [{path: bodies.sphere.mass_kg, values: [0.1]}]\nrepeats: 3\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("3 runs in 3 simulations"), std::string::npos) << outcome.out;
  const SweepTable table(folder / "out/sweep.h5");
  EXPECT_EQ(table.numbers("repeat"), (std::vector<double>{0, 1, 2}));
}

TEST(Sweep, ADryRunWritesNothing) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf("axes: [{path: bodies.sphere.mass_kg, values: [0.1, 0.11]}]\n"));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out", "--dry-run", "-j", "2"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(hasMatch(outcome.out,
                       "to do: 2 of 2 simulations, about .* with -j 2 \\([0-9]+ "
                       "ms each\\), at most about .*B on disk\n"))
      << outcome.out;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"press.yaml", "s.yaml"}));
}

TEST(Sweep, ShippedSweepsCanBeRun) {
  const std::map<std::string, std::string> plans = {
      {"hunt_crossley", "10000 points x 1 pipeline = 10000 runs in 1 simulation\n"},
      {"speed_thickness", "35 points x 3 pipelines = 105 runs in 105 simulations\n"},
      {"force_roughness", "264 points x 2 pipelines = 528 runs in 528 simulations\n"},
      {"nodes_mesh", "22 points x 1 pipeline x 2 repeats = 44 runs in 44 simulations\n"},
      {"fit_liver", "475 points x 1 pipeline = 475 runs in 1 simulation\n"}};
  std::size_t found = 0;
  for (const auto& entry : fs::directory_iterator(FISSURE_SOURCE_DIR "/configs/sweeps")) {
    if (entry.path().extension() != ".yaml") continue;
    const Outcome outcome = runFissure(Folder(), {"sweep", entry.path().string(), "--dry-run"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(plans.at(entry.path().stem())), std::string::npos) << outcome.out;
    ++found;
  }
  EXPECT_EQ(found, plans.size());
}

struct BadSweep {
  const char* name;
  std::string text;     ///< below the head, with "axes: "
  const char* message;  ///< a regular expression of all of stderr
};

class BadSweeps : public testing::TestWithParam<BadSweep> {};

TEST_P(BadSweeps, IsOneLineAndExitCode2) {
  const Folder folder;
  folder.write("press.yaml", pressScenario("[{pipeline: fukuhara}, {pipeline: default}]", "0.02", laws));
  folder.write("s.yaml", sweepOf(GetParam().text));
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  EXPECT_EQ(outcome.code, 2) << outcome.out;
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_TRUE(hasMatch(outcome.err, GetParam().message)) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadSweeps,
    testing::Values(
        BadSweep{"PathThatDoesNotExist", "axes: [{path: tools.spatula.colour, values: [1]}]\n",
                 "^s.yaml:4: axis tools.spatula.colour: unknown key \"colour\" in tools.spatula"},
        BadSweep{"ItemThatDoesNotExist", "axes: [{path: force.hx.k, values: [1]}]\n",
                 "^s.yaml:4: axis force.hx.k: force has no item \"hx\", did you mean \"hc\""},
        BadSweep{"LastValueOutOfRange", "axes: [{path: force.hc.k, values: [1, 2, -3]}]\n",
                 "^s.yaml:4: axis force.hc.k: force.hc.k is -3, expected"},
        BadSweep{"TextForANumber", "axes: [{path: force.hc.k, values: [1, soft]}]\n",
                 "^s.yaml:4: axis force.hc.k: .*soft"},
        BadSweep{"AxisWithinAxis",
                 "axes:\n  - {path: bodies.sphere.solver.damping, values: [0.1]}\n"
                 "  - {path: bodies.0.solver, values: [{damping: 0.2}]}\n",
                 "^s.yaml:6: axis bodies.0.solver: is the place of axis bodies.sphere.solver.damping or "
                 "within it"},
        BadSweep{"PipelineThatIsNotRun",
                 "pipelines: [fukuhara]\naxes: [{path: pipelines.1.settings, values: [stock, tuned]}]\n",
                 "^s.yaml:5: axis pipelines.1.settings: the sweep does not run default"},
        BadSweep{"WhichPipelines", "axes: [{path: pipelines, values: [[{pipeline: raycast}]]}]\n",
                 "^s.yaml:4: axis pipelines: changes which pipelines there are"},
        BadSweep{"NothingThatMoves", "axes: [{path: description, values: [a, b]}]\n",
                 "^s.yaml:4: axis description: changes no simulation"},
        BadSweep{
            "OtherLaws", "axes: [{path: force, values: [[{model: linear_elastic}]]}]\n",
            "^s.yaml: with force=.*: the force laws have other names or another order than in press.yaml"},
        BadSweep{"BadTogether", "axes: [{path: time.duration_s, values: [0.02, 0.0001]}]\n",
                 "^s.yaml(:4: axis|: with) time.duration_s.*press.yaml:4: time.step_s is 0.001"},
        BadSweep{"EmptyRange", "axes: [{path: force.hc.k, linear: {from: 3, to: 3, count: 4}}]\n",
                 "^s.yaml:4: axis force.hc.k linear: from and to are 3, expected a range"},
        BadSweep{"NoValues", "axes: [{path: force.hc.k, values: []}]\n", "^s.yaml:4: .* is empty, expected"},
        BadSweep{"DuplicateAxis",
                 "axes:\n  - {path: force.hc.k, values: [1]}\n  - {path: force.hc.k, values: [2]}\n",
                 "^s.yaml:6: a second axis on force.hc.k, expected one axis a path"},
        BadSweep{"MillionRuns",
                 "axes:\n  - {path: force.hc.k, linear: {from: 1, to: 2, count: 500}}\n"
                 "  - {path: force.hc.n, linear: {from: 1, to: 2, count: 1000}}\n",
                 "^s.yaml: plans 1000000 runs, expected at most 100000, or --yes"},
        BadSweep{"TheSameTwice",
                 "axes:\n  - {path: force.hc.n, values: [1, 2]}\n"
                 "  - {path: force.hc.k, values: [0.1, 5, 1e-1]}\n",
                 "^s.yaml:6: axis force.hc.k: 1e-1 is 0.1 again, expected each value once"},
        BadSweep{"TheSamePairTwice",
                 "axes:\n  - zip:\n    - {path: force.hc.k, values: [1, 1, 2, 1]}\n"
                 "    - {path: force.hc.n, values: [1, 2, 1, 2.0]}\n",
                 "^s.yaml:6: axis force.hc.k, force.hc.n: 1, 2.0 is 1, 2 again, expected each value once"},
        BadSweep{"NothingLeft",
                 "axes: [{path: force.hc.k, values: [1, 2]}]\nexclude: [[{path: force.hc.k, min: 0}]]\n",
                 "^s.yaml: exclude leaves no point, expected some"},
        BadSweep{"UnknownCurve",
                 "axes: [{path: force.hc.k, values: [1]}]\ncurves: {quantities: [forse], every_s: 0.01}\n",
                 "^s.yaml: curves.quantities: no quantity \"forse\" .*did you mean \"force\""},
        BadSweep{"UnknownPipeline", "pipelines: [fukuhra]\naxes: [{path: force.hc.k, values: [1]}]\n",
                 "press.yaml: no pipeline \"fukuhra\", did you mean \"fukuhara\""},
        BadSweep{"Empty", "", "^s.yaml:1: missing key \"axes\""}),
    [](const auto& bad) { return bad.param.name; });

TEST(BadSweeps, EmptyFileAndFoldersOfOthers) {
  const Folder folder;
  const auto expectRefused = [&](const std::vector<std::string>& words, const char* message) {
    const Outcome outcome = runFissure(folder, words);
    EXPECT_EQ(outcome.code, 2) << message;
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
    EXPECT_TRUE(hasMatch(outcome.err, message)) << outcome.err;
  };
  folder.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "0.02", laws));
  folder.write("empty.yaml", "");
  folder.write("s.yaml", sweepOf("axes: [{path: bodies.sphere.mass_kg, values: [0.1]}]\n"));
  folder.write("other.yaml", with(folder.read("s.yaml"), "name: sweep", "name: other"));
  fs::create_directory(folder / "mine");
  folder.write("mine/thesis.txt", "do not touch");
  ASSERT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out"}).code, 0);
  EXPECT_NE(folder.read("out/manifest.json").find("\"directory\":\"..\""), std::string::npos)
      << "from the folder on, which was not there when it was planned: both can be moved";
  expectRefused({"sweep", "empty.yaml", "-o", "o"}, "^empty.yaml: has size 0, expected a text file");
  expectRefused({"sweep", "none.yaml", "-o", "o"}, "^none.yaml: no such file");
  expectRefused({"sweep", "other.yaml", "-o", "out"},
                "^out: holds the sweep \"sweep\", expected another folder");
  expectRefused({"sweep", "s.yaml", "-o", "mine"}, "^mine: is no folder of a sweep");
  expectRefused({"sweep", "mine"}, "^mine: holds no sweep");
  expectRefused({"sweep", "status", "mine"}, "^mine: holds no sweep");
  expectRefused({"sweep", "s.yaml", "-o", "out", "--shard", "3/2"},
                "^--shard 3/2: not a shard, expected I/N");
  expectRefused({"sweep"}, "no sweep file is named");
  folder.write("measured.csv", "depth_mm,force_N\n0,0\n1,1\n# \xb5m\n2,3\n");
  folder.write("fit.yaml", sweepOf("axes: [{path: force.hc.k, values: [1, 2]}]\n"
                                   "curves: {quantities: [force, indentation], every_s: 0.01}\n"
                                   "fit: {curve: measured.csv}\n"));
  expectRefused({"sweep", "fit.yaml", "-o", "o"}, "^measured.csv:4: binary data or not UTF-8, expected");
  expectRefused({"sweep", "s.yaml", "-o",
                 "b\xe4"
                 "d"},
                "^.*/b\\?d: its path is not UTF-8, expected");
  fs::create_directory(folder /
                       "b\xe4"
                       "d");
  fs::rename(folder / "out", folder /
                                 "b\xe4"
                                 "d/out");
  expectRefused({"sweep",
                 "b\xe4"
                 "d/out"},
                "^.*/b\\?d: its path is not UTF-8, expected");
  fs::rename(folder /
                 "b\xe4"
                 "d/out",
             folder / "out");
  EXPECT_FALSE(fs::exists(folder / "o"));
  folder.write("out/manifest.json", "{\"format\": \"fissure-sweep-plan\", \"format_version\": 1}");
  expectRefused({"sweep", "status", "out"}, "^out/manifest.json: damaged");
  EXPECT_EQ(folder.read("mine/thesis.txt"), "do not touch");
}

}  // namespace
}  // namespace fissure::programs::sweep_test
