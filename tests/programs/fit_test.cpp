// Fits of force laws to measured curves, and rankings of sweeps by them, as a user sees them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "program.h"
#include "scenarios.h"
#include "store/force_inputs.h"
#include "store/read_series.h"
#include "table/sweep_table_writer.h"
#include "text/scalars.h"

namespace fissure::programs::fit_test {
namespace {

using Json = nlohmann::json;
const std::string example = FISSURE_SOURCE_DIR "/configs/curves/probe_presses.csv";

/// Is the truth in its 95 % interval?
void expectCovered(const Json& parameter, double truth) {
  EXPECT_LE(parameter["low"].get<double>(), truth) << parameter;
  EXPECT_GE(parameter["high"].get<double>(), truth) << parameter;
}

TEST(Fit, TheExampleIsWhatItsScriptWrites) {
  const Folder folder;
  const Outcome made =
      runTool(folder, {"/usr/bin/python3", FISSURE_SOURCE_DIR "/scripts/make_probe_curve.py"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, runTool(folder, {"cat", example}).out);
}

TEST(Fit, FindsWhatTheExampleWasMadeWith) {
  const Folder folder;
  const Outcome text = runFissure(folder, {"fit", example});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_TRUE(text.out.starts_with("probe_presses: F = F0 + k d^n + lambda d^n d', 91 points\n")) << text.out;
  for (const char* part : {"\n  k ", "N/m^n", "\n  lambda/k ", "\n  RMS residual 0.01", ", R2 0.99"})
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
  const Json fit = Json::parse(runFissure(folder, {"fit", example, "--json"}).out);
  EXPECT_EQ(fit["exit_code"], 0);
  const Json& curve = fit["curves"].at(0);
  EXPECT_EQ(curve["converged"], true);
  EXPECT_EQ(curve["file"], example);
  EXPECT_EQ(curve["notes"], Json::array());
  expectCovered(curve["parameters"]["k"], 6.08e5);
  expectCovered(curve["parameters"]["lambda"], 3.04e5);
  expectCovered(curve["parameters"]["n"], 2.4);
  expectCovered(curve["parameters"]["F0"], 0.029);
  EXPECT_NEAR(curve["lambda_over_k_s_m"].get<double>(), 0.5, curve["lambda_over_k_half_width_s_m"]);
  EXPECT_EQ(folder.names(), std::vector<std::string>());
}

TEST(Fit, FreeAndFixedCoefficientsAndColumnsAreTheUsers) {
  const Folder folder;
  folder.write("a.csv", "d;F;probe\n0;100;x\n1;300;x\n2;520;x\n3;690;x\n1;1;y\n2;2;y\n3;3;y\n4;4;y\n");
  const std::vector<std::string> words = {
      "fit", "a.csv", "--columns", "depth=d:mm,force=2:mN,curve=3", "--law", "linear_elastic", "--json"};
  const Json both = Json::parse(runFissure(folder, words).out);
  EXPECT_NEAR(both["curves"][0]["parameters"]["k"]["value"].get<double>(), 199, 1e-3);
  EXPECT_NEAR(both["curves"][1]["parameters"]["k"]["value"].get<double>(), 1, 1e-6);
  EXPECT_EQ(both["curves"][1]["curve"], "a:y");
  EXPECT_FALSE(both["curves"][0]["parameters"].contains("n"));
  std::vector<std::string> more = words;
  more.insert(more.end(), {"--fix", "F0=0.1"});
  const Json fixed = Json::parse(runFissure(folder, more).out);
  EXPECT_EQ(fixed["curves"][0]["parameters"]["F0"], (Json{{"value", 0.1}, {"unit", "N"}, {"free", false}}));
  more = words;
  more.insert(more.end(), {"--free", "k", "--together"});
  const Json together = Json::parse(runFissure(folder, more).out);
  EXPECT_EQ(together["curves"].size(), 1u);
  EXPECT_EQ(together["curves"][0]["points"], 8);
  EXPECT_EQ(together["curves"][0]["parameters"]["F0"]["value"], 0.0);
}

/// F = 0.02 N + 0.05 N (exp(400/m d) - 1) at depths of 0 to 5 mm, to a micronewton.
std::string stiffeningCurve() {
  std::string text = "depth_m,force_N\n";
  for (int i = 0; i <= 25; ++i) {
    const double depth_m = 0.0002 * i;
    char line[64];
    std::snprintf(line, sizeof line, "%.4f,%.6f\n", depth_m, 0.02 + 0.05 * std::expm1(400 * depth_m));
    text += line;
  }
  return text;
}

TEST(Fit, OfTissueThatStiffensExponentially) {
  const Folder folder;
  folder.write("a.csv", stiffeningCurve());
  const Outcome outcome = runFissure(folder, {"fit", "a.csv", "--law", "exponential"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("F = F0 + k (exp(a d) - 1) + c d'"), std::string::npos) << outcome.out;
  const Json fit = Json::parse(runFissure(folder, {"fit", "a.csv", "--law", "exponential", "--json"}).out);
  const Json& found = fit["curves"][0]["parameters"];
  EXPECT_NEAR(found["a"]["value"].get<double>(), 400, 0.1);
  EXPECT_EQ(found["a"]["unit"], "1/m");
  EXPECT_NEAR(found["k"]["value"].get<double>(), 0.05, 1e-4);
  EXPECT_NEAR(found["F0"]["value"].get<double>(), 0.02, 1e-5);
  EXPECT_EQ(found["c"]["free"], false) << "no rates, no damper";
}

TEST(Fit, ACurveThatCannotBeFittedDoesNotStopTheOthers) {
  const Folder folder;
  folder.write("few.csv", "depth_mm,force_N\n1,0.1\n2,0.2\n");
  const Outcome outcome = runFissure(folder, {"fit", "few.csv", example});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(
      outcome.out.find("few.csv: not fitted: 2 points for 3 free coefficients, expected more points than "
                       "these\n"),
      std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("\nprobe_presses  "), std::string::npos) << outcome.out;
}

TEST(Fit, BadInputIsOneLine) {
  const Folder folder;
  folder.write("few.csv", "depth_mm,force_N\n1,0.1\n2,0.2\n");
  folder.write("bad.csv", "depth_mm,force_N\n1,0.1\n2,much\n");
  const auto expectRefused = [&](std::vector<std::string> words, const std::string& line) {
    words.insert(words.begin(), "fit");
    const Outcome outcome = runFissure(folder, words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, line + "\n");
  };
  expectRefused({"no.csv"}, "no.csv: no such file, expected a text file of numbers");
  expectRefused({"bad.csv"},
                "bad.csv:3: \"much\" in column \"force_N\", expected a number like -0.0125 or nothing");
  expectRefused({"few.csv"}, "few.csv: 2 points for 3 free coefficients, expected more points than these");
  expectRefused(
      {example, "--law", "voigt"},
      "--law voigt: no such force law, expected one of hunt_crossley, kelvin_voigt, linear_elastic, "
      "exponential");
  expectRefused({example, "--free", "k,m"},
                "--free k,m: hunt_crossley has no coefficient \"m\", did you mean \"k\"?");
  expectRefused({example, "--free", "k"}, "--free k: n is neither free nor fixed, expected --fix n=NUMBER");
  expectRefused({example, "--fix", "n"}, "--fix n: expected COEFFICIENT=NUMBER, as in lambda=0");
  expectRefused({example, "--fix", "n=-1"}, "--fix n=-1: expected a number above 0");
  expectRefused({example, "--free", "k,n", "--fix", "k=1"}, "--fix k=1: k is free too, expected one of them");
  expectRefused({example, "--fix", "F0=inf"}, "--fix F0=inf: expected COEFFICIENT=NUMBER, as in lambda=0");
  expectRefused({example, "--fix", "n=2", "--fix", "n=3"},
                "--fix n=3: n is fixed already, expected one value");
  expectRefused({example, "--match", "time"},
                "--match time: nothing is simulated, expected --result or --sweep too");
  expectRefused({example, "--best", "3"}, "fissure fit: --best requires --sweep (see fissure fit --help)");
  expectRefused({example, "--sweep", ".", "--law", "hunt_crossley"},
                "fissure fit: --law excludes --sweep (see fissure fit --help)");
  expectRefused({example, "--sweep", ".", "--free", "k"},
                "fissure fit: --free excludes --sweep (see fissure fit --help)");
  expectRefused({example, "--sweep", ".", "--fix", "n=2"},
                "--fix n=2: nothing is fitted with --sweep, expected F0 alone, and once");
  expectRefused(
      {example, "--result", "few.csv"},
      "few.csv: not an HDF5 file, expected a fissure result (cannot open: file signature not found)");
  expectRefused({example, "--sweep", "."}, "./sweep.h5: no such file, expected a fissure sweep");
}

/// A blade pressed in and its force by Hunt and Crossley's law with k = 200, lambda = 50, n = 1.3.
void runPress(const Folder& folder, const std::string& record) {
  folder.write(
      "s.yaml",
      pressScenario("[{pipeline: fukuhara}]", "0.03",
                    "force: [{name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}]\n" + record));
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "press.h5"}).code, 0);
}

TEST(Fit, FindsTheLawOfASimulationInItsOwnForce) {
  const Folder folder;
  runPress(folder, "record: {force_inputs: true}\n");
  const SeriesData force = readSeries(folder / "press.h5", "/pipelines/fukuhara/force");
  const SeriesData time = readSeries(folder / "press.h5", "/pipelines/fukuhara/time");
  const auto rows = readForceInputs(folder / "press.h5", "fukuhara").row_sizes;
  std::string curve = "time_s,force_N\n";
  for (std::size_t i = 0; i < time.values.size(); ++i) {
    if (rows[i] == 0) continue;
    const double* of_step = &force.values[3 * i];
    const double noise_N = i % 2 == 0 ? 1e-4 : -1e-4;
    curve += formatReal(time.values[i]) + "," +
             formatReal(std::hypot(of_step[0], of_step[1], of_step[2]) + 0.02 + noise_N) + "\n";
  }
  folder.write("force.csv", curve);
  const Outcome outcome = runFissure(folder, {"fit", "force.csv", "--result", "press.h5:fukuhara", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json fit = Json::parse(outcome.out)["curves"].at(0);
  for (const auto& [name, truth] :
       std::vector<std::pair<std::string, double>>{{"k", 200}, {"lambda", 50}, {"n", 1.3}, {"F0", 0.02}}) {
    expectCovered(fit["parameters"][name], truth);
    EXPECT_NEAR(fit["parameters"][name]["value"].get<double>(), truth, 0.05 * truth) << name;
  }
}

TEST(Fit, ASimulationWithoutInputsOfItsLawsIsRefused) {
  const Folder folder;
  runPress(folder, "");
  const Outcome outcome = runFissure(folder, {"fit", example, "--result", "press.h5"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err,
            "press.h5: run fukuhara has no force_inputs/time, expected a run with record: {force_inputs: "
            "true}\n");
}

TEST(Fit, RatesThatDifferFromTheSimulatedOnesAreSaid) {
  const Folder folder;
  runPress(folder, "record: {force_inputs: true}\n");
  std::string curve = "time_s,depth_mm,force_N\n";
  for (int i = 0; i < 20; ++i)  // the press takes 0.03 s
    curve += std::to_string(i) + "," + std::to_string(0.05 * i) + "," + std::to_string(0.001 * i * i) + "\n";
  folder.write("slow.csv", curve);
  const std::string note = "m/s in the simulation, whose count";
  const auto said = [&](const std::string& fixed) {
    const Outcome outcome =
        runFissure(folder, {"fit", "slow.csv", "--result", "press.h5", "--fix", "n=1.3", "--fix", fixed});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out.find(note) != std::string::npos;
  };
  EXPECT_TRUE(said("F0=0"));
  EXPECT_TRUE(said("lambda=1"));
  EXPECT_FALSE(said("lambda=0"));
}

/// A sweep of three runs whose force is k times the way of the tool, 10 mm/s for 0.2 s; the last ends early.
void writeSweep(const std::filesystem::path& path) {
  SweepTableLayout layout;
  layout.title = "springs";
  layout.design = "grid";
  layout.axes = {{"k", "force.spring.k", true}};
  layout.laws = {"spring"};
  layout.curves = {{"indentation", "m", "way of the tool", false}, {"force", "N", "force", true}};
  for (int i = 0; i <= 20; ++i) layout.curve_time_s.push_back(0.01 * i);
  layout.runs = 3;
  SweepTableWriter writer(path, layout);
  for (int run = 0; run < 3; ++run) {
    SweepRun row{
        .point = run, .pipeline = "fukuhara", .end = RunEnd::ok, .file = "runs/" + std::to_string(run)};
    const double k = 100.0 * (run + 1);
    row.values = {formatReal(k)};
    for (const double time_s : layout.curve_time_s) row.curves.push_back(0.01 * time_s);
    for (const double time_s : layout.curve_time_s)
      row.curves.push_back(run == 2 && time_s > 0.1 ? NAN : 0.01 * time_s * k);
    writer.append(row);
  }
  writer.finish(true);
}

TEST(Fit, RanksTheRunsOfASweepByTimeAndByDepth) {
  const Folder folder;
  std::filesystem::create_directory(folder / "sweep");
  writeSweep(folder / "sweep" / "sweep.h5");
  folder.write("time.csv", "time_ms,force_N\n10,0.02\n55,0.11\n150,0.3\n300,0.6\n");
  folder.write("depth.csv", "depth_mm,force_N\n0.1,0.07\n0.55,0.16\n1.5,0.35\n");
  Outcome outcome = runFissure(folder, {"fit", "time.csv", "--sweep", "sweep", "--fix", "F0=0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("time: 2 of 3 simulated curves compared at 3 points\n")) << outcome.out;
  EXPECT_NE(outcome.out.find("left out 1 of 4 points that no run reaches\n"), std::string::npos);
  outcome = runFissure(folder, {"fit", "depth.csv", "--sweep", "sweep", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json ranking = Json::parse(outcome.out)["curves"][0]["ranking"];
  ASSERT_EQ(ranking.size(), 3u);
  EXPECT_EQ(ranking[0]["values"]["force.spring.k"], 200.0);
  EXPECT_NEAR(ranking[0]["misfit_N"].get<double>(), 0, 1e-12);
  EXPECT_NEAR(ranking[0]["F0_N"].get<double>(), 0.05, 1e-12);
  EXPECT_EQ(ranking[0]["law"], "spring");
  EXPECT_EQ(ranking[1]["run"], 0);
  EXPECT_EQ(ranking[2]["misfit_N"], nullptr);
  // 0.05 N above the run with k = 200 throughout.
  outcome = runFissure(folder, {"fit", "depth.csv", "--sweep", "sweep", "--json", "--fix", "F0=0.04"});
  const Json fixed = Json::parse(outcome.out)["curves"][0]["ranking"][0];
  EXPECT_EQ(fixed["values"]["force.spring.k"], 200.0);
  EXPECT_NEAR(fixed["misfit_N"].get<double>(), 0.01, 1e-12);
  EXPECT_EQ(fixed["F0_N"], 0.04);
  folder.write("late.csv", "time_s,force_N\n5,1\n6,2\n");
  outcome = runFissure(folder, {"fit", "late.csv", "--sweep", "sweep"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err,
            "late.csv: no run reaches the measured points, expected simulations as long or deep as these\n");
}

TEST(Fit, ACurveThatCannotBeRankedDoesNotStopTheOthers) {
  const Folder folder;
  std::filesystem::create_directory(folder / "sweep");
  writeSweep(folder / "sweep" / "sweep.h5");
  folder.write("late.csv", "time_s,force_N\n5,1\n6,2\n");
  folder.write("depth.csv", "depth_mm,force_N\n-1,0\n0.1,0.07\n0.55,0.16\n,3\n1.5,0.35\n");
  const std::vector<std::string> words = {"fit", "late.csv", "depth.csv", "--sweep", "sweep"};
  Outcome outcome = runFissure(folder, words);
  EXPECT_EQ(outcome.code, 3);
  for (const char* part :
       {"late.csv: not ranked: no run reaches the measured points, ",
        "\ndepth: 2 of 3 simulated curves compared at 3 points\n", "\nleft out 1 row without numbers\n",
        "\nleft out 1 row before contact (depth < 0)\n"})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
  folder.write("back.csv", "time_s,depth_mm,force_N\n0,0.1,0.02\n1,1.5,0.3\n2,0.55,0.1\n");
  EXPECT_NE(
      runFissure(folder, {"fit", "back.csv", "--sweep", "sweep"}).out.find("\n1 of 3 points are shallower"),
      std::string::npos);
  std::vector<std::string> more = words;
  more.emplace_back("--json");
  outcome = runFissure(folder, more);
  EXPECT_EQ(outcome.code, 3);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["exit_code"], 3);
  EXPECT_TRUE(json["curves"][0].contains("problem"));
  EXPECT_EQ(json["curves"][1]["file"], "depth.csv");
  EXPECT_EQ(json["curves"][1]["notes"].size(), 2u);
}

}  // namespace
}  // namespace fissure::programs::fit_test
