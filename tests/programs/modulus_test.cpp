// Moduli fitted to measured curves by a simulated press, as a user sees them.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "program.h"
#include "store/read_series.h"
#include "text/scalars.h"

namespace fissure::programs::modulus_test {
namespace {

using Json = nlohmann::json;

/// Is the truth in its 95 % interval?
void expectCovered(const Json& parameter, double truth) {
  EXPECT_LE(parameter["low"].get<double>(), truth) << parameter;
  EXPECT_GE(parameter["high"].get<double>(), truth) << parameter;
}

/// A block of 144 tetrahedra, bonded below, into which a ball sinks 1.5 mm; `model`: the keys of its body.
void writeProbe(const Folder& folder, const std::string& model, const std::string& more = "") {
  folder.write("probe.yaml",
               "format: 1\nname: probe\ndescription: A ball on a block.\ntime: {step_s: 0.001}\n"
               "world: {gravity_m_s2: [0, 0, 0]}\nbodies:\n"
               "  - name: block\n"
               "    shape: {type: box, size_m: [0.02, 0.01, 0.02], cells: [4, 2, 4]}\n" +
                   model +
                   "    fixed: [{below_m: -0.0049}]\n"
                   "tools:\n"
                   "  - name: tip\n"
                   "    shape: {type: sphere, radius_m: 0.004, subdivisions: 2}\n"
                   "    motion:\n"
                   "      type: script\n"
                   "      start_m: [0, 0.0100, 0]\n"
                   "      segments: [{move_to_m: [0, 0.0075, 0], speed_m_s: 0.02}]\n"
                   "pipelines: [{pipeline: swept}]\n" +
                   more);
}

void runProbe(const Folder& folder, const std::string& model, const std::string& more = "") {
  writeProbe(folder, model, more);
  const Outcome run = runFissure(folder, {"run", "probe.yaml", "-o", "probe.h5", "--no-frames", "--force"});
  ASSERT_EQ(run.code, 0) << run.err;
}

const std::string elastic_model =
    "    model: elastic\n    margin_m: 0.00001\n"
    "    elastic: {youngs_modulus_Pa: 20000, poissons_ratio: 0.3, viscosity_Pa_s: 5}\n";

/// The force of the run at its own steps of contact, times `scale`, with F0 and `noise_N` to either side.
std::string probeCurve(const Folder& folder, double scale, double F0_N, double noise_N) {
  const SeriesData force = readSeries(folder / "probe.h5", "/pipelines/swept/reaction_force");
  const SeriesData position = readSeries(folder / "probe.h5", "/pipelines/swept/tool_position");
  std::string curve = "depth_m,force_N,lower_quartile_N,upper_quartile_N\n";
  std::size_t start = 0;
  while (force.values[3 * start + 1] == 0) ++start;
  --start;
  for (std::size_t i = start; i < force.values.size() / 3; i += 8) {
    const double force_N = scale * force.values[3 * i + 1] + F0_N + (i % 16 < 8 ? noise_N : -noise_N);
    curve += formatReal(position.values[3 * start + 1] - position.values[3 * i + 1]) + "," +
             formatReal(force_N) + "," + formatReal(force_N - 1e-3) + "," + formatReal(force_N + 1e-3) + "\n";
  }
  return curve;
}

TEST(ModulusFit, FindsTheModulusThatASimulationIsScaledBy) {
  const Folder folder;
  runProbe(folder, elastic_model);
  folder.write("exact.csv", probeCurve(folder, 3.5, 0.06, 0));
  const std::vector<std::string> words = {"fit",      "exact.csv",    "--modulus",
                                          "probe.h5", "--most-depth", "0.0011"};
  const Outcome text = runFissure(folder, words);
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_TRUE(text.out.starts_with(
      "exact: F = E/E0 f(d) + F0, f of probe.h5:swept at E0 = 2e+04 Pa, 7 of 10 points\n"))
      << text.out;
  for (const char* part :
       {"\n  E ", " within the quartiles\n", "assumed, not fitted: Poisson's ratio 0.3, neo_hookean"})
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
  std::vector<std::string> more = words;
  more.emplace_back("--json");
  Json fit = Json::parse(runFissure(folder, more).out)["curves"][0]["fits"][0];
  EXPECT_NEAR(fit["parameters"]["E"]["value"].get<double>(), 7e4, 7e4 * 1e-6);
  EXPECT_NEAR(fit["parameters"]["F0"]["value"].get<double>(), 0.06, 0.06 * 1e-6);
  EXPECT_EQ(fit["parameters"]["d0"], (Json{{"value", 0.0}, {"unit", "m"}, {"free", false}}));
  ASSERT_GE(fit["predictions"].size(), 1u);
  for (const Json& point : fit["predictions"])
    EXPECT_NEAR(point["predicted_N"].get<double>(), point["measured_N"].get<double>(), 1e-6);
  folder.write("noisy.csv", probeCurve(folder, 3.5, 0.06, 5e-3));
  const Outcome noisy = runFissure(folder, {"fit", "noisy.csv", "--modulus", "probe.h5:swept", "--json"});
  ASSERT_EQ(noisy.code, 0) << noisy.err;
  fit = Json::parse(noisy.out)["curves"][0]["fits"][0];
  expectCovered(fit["parameters"]["E"], 7e4);
  expectCovered(fit["parameters"]["F0"], 0.06);
  // Two simulations side by side, the better one first, and offsets of the depth.
  const Outcome both = runFissure(folder, {"fit", "exact.csv", "--modulus", "probe.h5", "--modulus",
                                           "probe.h5:swept", "--most-depth", "0.001", "--free", "E,d0"});
  EXPECT_EQ(both.code, 0) << both.err;
  EXPECT_TRUE(both.out.starts_with("exact: 2 simulations, the least misfit first\n")) << both.out;
}

TEST(ModulusFit, WhatHasNoModulusIsRefused) {
  const Folder folder;
  runProbe(folder, elastic_model);
  folder.write("curve.csv", "depth_mm,force_N\n0.2,0.1\n0.5,0.2\n1,0.4\n9,4\n");
  folder.write("times.csv", "time_s,force_N\n0.2,0.1\n0.5,0.2\n1,0.4\n");
  const auto refused = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "fit");
    const Outcome outcome = runFissure(folder, words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    return outcome.err;
  };
  EXPECT_TRUE(
      refused({"curve.csv", "--modulus", "probe.h5"})
          .starts_with("curve.csv: a point 9 mm deep is deeper than the simulation, which ends at 1.5"));
  EXPECT_EQ(refused({"times.csv", "--modulus", "probe.h5"}),
            "times.csv: the curve has no depths, expected a column of them\n");
  EXPECT_TRUE(refused({"curve.csv", "--modulus", "probe.h5", "--free", "E,n"})
                  .starts_with("--free E,n: nothing named \"n\" in E/E0 f(d + d0) + F0, "));
  EXPECT_EQ(refused({"curve.csv", "--modulus", "probe.h5", "--free", "F0"}),
            "--free F0: E is neither free nor fixed, expected --fix E=NUMBER\n");
  EXPECT_EQ(refused({"curve.csv", "--modulus", "probe.h5", "--fix", "E=-1"}),
            "--fix E=-1: expected a number above 0\n");
  EXPECT_EQ(refused({"curve.csv", "--most-depth", "0.001"}),
            "fissure fit: --most-depth requires --modulus (see fissure fit --help)\n");
  EXPECT_EQ(refused({"curve.csv", "--modulus", "no.h5"}), "no.h5: no such file, expected a fissure result\n");
  runProbe(folder, "    mass_kg: 0.01\n", "");
  EXPECT_EQ(refused({"curve.csv", "--modulus", "probe.h5"}),
            "probe.h5: its body has no modulus, expected one with model: elastic\n");
}

namespace fs = std::filesystem;

constexpr const char* few_points = "depth_mm,force_N\n0.2,0.1\n0.5,0.2\n1,0.4\n";

/// `fit curve.csv --modulus` of each of `files`, into the folder "out".
Outcome fitTo(const Folder& folder, const std::vector<std::string>& files) {
  std::vector<std::string> words = {"fit", "curve.csv", "--out", "out", "--json"};
  for (const std::string& file : files) words.insert(words.end(), {"--modulus", file});
  return runFissure(folder, words);
}

TEST(ModulusFit, SimulatesAScenarioFirstAndOnlyOnce) {
  const Folder folder;
  writeProbe(folder, elastic_model);
  folder.write("curve.csv", few_points);
  const Outcome first = fitTo(folder, {"probe.yaml"});
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(Json::parse(first.out)["curves"][0]["fits"][0]["result"], "out/probe.h5:swept");
  const auto written = fs::last_write_time(folder / "out/probe.h5");
  const Outcome again = fitTo(folder, {"probe.yaml"});
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(fs::last_write_time(folder / "out/probe.h5"), written) << "finished, and so not made again";
  // The same numbers as from `fissure run`, whose default folder is the default here too.
  runProbe(folder, elastic_model);
  EXPECT_EQ(Json::parse(fitTo(folder, {"probe.h5"}).out)["curves"][0]["fits"][0]["parameters"],
            Json::parse(first.out)["curves"][0]["fits"][0]["parameters"]);
  // What is of another scenario is neither used nor lost.
  writeProbe(folder, elastic_model, "measure: {certify: true}\n");
  const Outcome other = fitTo(folder, {"probe.yaml"});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(other.err.starts_with("out/probe.h5: is not of probe.yaml as it is now, ")) << other.err;
  EXPECT_EQ(fs::last_write_time(folder / "out/probe.h5"), written);
}

TEST(ModulusFit, SimulatesASweepFirstAndGoesOnWithIt) {
  const Folder folder;
  writeProbe(folder, elastic_model);
  folder.write("curve.csv", few_points);
  folder.write("nu.yaml",
               "format: 1\nname: nu\ndescription: Two ratios.\nbase: probe.yaml\nkeep: results\n"
               "axes: [{path: bodies.block.elastic.poissons_ratio, values: [0.3, 0.45]}]\n");
  const Outcome first = fitTo(folder, {"nu.yaml"});
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(Json::parse(first.out)["curves"][0]["fits"].size(), 2u);
  const std::string gone = Json::parse(first.out)["curves"][0]["fits"][0]["result"];
  const std::string kept = Json::parse(first.out)["curves"][0]["fits"][1]["result"];
  const auto file = [&](const std::string& result) { return folder / result.substr(0, result.find(':')); };
  const auto written = fs::last_write_time(file(kept));
  fs::remove(file(gone));
  const Outcome again = fitTo(folder, {"nu.yaml"});
  EXPECT_EQ(again.out, first.out) << again.err;
  EXPECT_EQ(fs::last_write_time(file(kept)), written);
  EXPECT_TRUE(fs::exists(file(gone)));
}

TEST(ModulusFit, AKilledOneLosesNoFinishedResult) {
  const Folder folder;
  writeProbe(folder, elastic_model);
  folder.write("curve.csv", few_points);
  // The second takes hours.
  folder.write("endless.yaml", "base: probe.yaml\nname: endless\ntime: {step_s: 0.000001, duration_s: 90}\n");
  Program fit(folder, {fissureProgram(), "fit", "curve.csv", "--out", "out", "--modulus", "probe.yaml",
                       "--modulus", "endless.yaml"});
  const pid_t first = fit.waitForWorker();
  ASSERT_GT(first, 0);
  const pid_t second = fit.waitForWorker(first);
  ASSERT_GT(second, 0);
  fit.send(SIGKILL);
  fit.wait();
  EXPECT_TRUE(endsSoon(second));
  const auto written = fs::last_write_time(folder / "out/probe.h5");
  EXPECT_EQ(fitTo(folder, {"probe.yaml"}).code, 0);
  EXPECT_EQ(fs::last_write_time(folder / "out/probe.h5"), written);
}

TEST(ModulusFit, WhatCannotBeFittedIsNotSimulated) {
  const Folder folder;
  folder.write("curve.csv", few_points);
  writeProbe(folder, "    mass_kg: 0.01\n");
  folder.write("s.yaml",
               "format: 1\nname: s\ndescription: No results.\nbase: probe.yaml\n"
               "axes: [{path: tools.tip.shape.radius_m, values: [0.004, 0.005]}]\n");
  const auto refused = [&](const std::vector<std::string>& files) {
    const Outcome outcome = fitTo(folder, files);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(folder / "out"));
    return outcome.err;
  };
  EXPECT_EQ(refused({"probe.yaml"}),
            "probe.yaml: its body has no modulus, expected one with model: elastic\n");
  EXPECT_EQ(refused({"s.yaml"}), "s.yaml: keeps no result of its simulations, expected keep: results\n");
  EXPECT_EQ(refused({"missing.yaml"}).substr(0, 14), "missing.yaml: ");
  EXPECT_EQ(runFissure(folder, {"fit", "curve.csv", "--out", "out"}).code, 2) << "--out needs --modulus";
}

}  // namespace
}  // namespace fissure::programs::modulus_test
