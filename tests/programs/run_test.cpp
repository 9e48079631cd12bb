// What a good run leaves: a result, a table, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/hash.h"
#include "files/input_file.h"
#include "program.h"
#include "scenario/catalog.h"
#include "scenario/pipeline_table.h"
#include "scenarios.h"
#include "store/read_series.h"
#include "store/result_file.h"

namespace fissure::programs::run_test {
namespace {

using Names = std::vector<std::string>;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(Run, WritesOneFileBelowResults) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]"));
  const Outcome outcome = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "no terminal, less than five seconds: no progress line";
  EXPECT_EQ(folder.names(), (Names{"out", "s.yaml"}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 1);
  const ResultInfo info = readResultInfo(folder / "out/press.h5");
  EXPECT_TRUE(info.complete);
  ASSERT_EQ(info.pipelines.size(), 2u);
  EXPECT_EQ(info.pipelines[0].name, "default");
  EXPECT_EQ(info.pipelines[1].name, "fukuhara");
  for (const PipelineResult& pipeline : info.pipelines) EXPECT_EQ(nameOf(pipeline.status.end), "ok");
}

// Header of three lines, one line a pipeline, what must be known beside the numbers, and where the result is.
// Numbers end in one column, verdicts begin in one.
TEST(Run, PrintsAnAlignedTable) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{name: a_long_name, pipeline: default}, {pipeline: fukuhara}]",
                                       "0.03", "force: [{model: hunt_crossley}]\n"));
  const Outcome outcome =
      runFissure(folder, {"run", "s.yaml", "-o", "out.h5", "--set", "measure.certify=true"});
  const std::vector<std::string> lines = linesOf(outcome.out);
  ASSERT_GE(lines.size(), 7u) << outcome.out;
  const std::size_t verdict = lines[0].find("verdict");
  ASSERT_NE(verdict, std::string::npos) << outcome.out;
  for (const std::size_t row : {3u, 4u}) {
    ASSERT_GT(lines[row].size(), verdict) << outcome.out;
    EXPECT_EQ(lines[row].substr(verdict - 2, 2), "  ") << outcome.out;
    EXPECT_NE(lines[row][verdict], ' ') << outcome.out;
    EXPECT_NE(lines[row][verdict - 3], ' ') << outcome.out;
  }
  EXPECT_EQ(lines.back(), "result: out.h5");
  EXPECT_EQ(lines[lines.size() - 2].substr(0, 31), "reaction: of a shell of springs");
  const std::vector<std::string> cells = wordsOf(lines[4].substr(0, verdict));
  ASSERT_EQ(cells.size(), 17u) << lines[4];
  EXPECT_EQ(cells[0], "fukuhara");
  EXPECT_EQ(cells[1], "finished");
  for (std::size_t i = 2; i < cells.size(); ++i)
    EXPECT_NE(cells[i], "-") << "column " << i << "\n" << outcome.out;
  const std::string info = runFissure(folder, {"info", "out.h5"}).out;
  EXPECT_NE(info.find(lines[3] + "\n" + lines[4]), std::string::npos);
  const ResultInfo result = readResultInfo(folder / "out.h5");
  for (const SummaryValue& value : result.pipelines.at(0).summary) {
    if (std::holds_alternative<std::string>(value.value)) continue;
    EXPECT_NE(info.find("\n" + value.name + " "), std::string::npos) << value.name;
  }
}

/// The press scenario with the sphere as it is, the blade somewhere else, and some expectations.
std::string missedScenario(const std::string& expect) {
  return with(with(pressScenario("[{pipeline: fukuhara}]", "0.01", expect), "start_m: [0, 0.062, 0]",
                   "start_m: [0, 0.2, 0]"),
              "move_to_m: [0, 0.052, 0]", "move_to_m: [0, 0.19, 0]");
}

// A sphere that nobody touches is at 0.000 mm, and proves nothing.
TEST(Run, ATrialThatTouchesNothingIsNamedAndHoldsNoUpperBound) {
  const Folder folder;
  const std::string bound = "{quantity: max_penetration_depth_m, max: 0.0005";
  folder.write("s.yaml", missedScenario("expect: [" + bound + "}]\n"));
  const Outcome missed = runFissure(folder, {"run", "s.yaml", "-o", "out.h5"});
  EXPECT_EQ(missed.code, 1) << missed.out;
  EXPECT_NE(missed.out.find("never touched tissue\n"), std::string::npos) << missed.out;
  EXPECT_NE(missed.out.find("fukuhara: never touched tissue: spatula\n"), std::string::npos) << missed.out;
  EXPECT_NE(missed.out.find("but spatula never touched tissue (contact: any lets that pass)"),
            std::string::npos)
      << missed.out;
  folder.write("s.yaml", missedScenario("expect: [" + bound + ", contact: any}]\n"));
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "any.h5"}).code, 0);
}

// 4 x 4 nodes on 40 x 15 mm, before a sphere of 32 triangles and before one of 512.
TEST(Run, NodesTooWideApartAreWarnedOfInValidatePlanAndTable) {
  const Folder folder;
  const std::string warning = "nodes are up to";
  for (const bool fine : {false, true}) {
    folder.write("s.yaml", with(pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.003"),
                                "subdivisions: 1", fine ? "subdivisions: 3" : "subdivisions: 1"));
    for (const char* verb : {"validate", "plan"}) {
      const std::string said = runFissure(folder, {verb, "s.yaml"}).out;
      EXPECT_EQ(said.find("warning: tools.spatula.nodes: " + warning) != std::string::npos, fine) << said;
      EXPECT_EQ(runFissure(folder, {verb, "s.yaml", "--pipeline", "default"}).out.find(warning),
                std::string::npos);
    }
    const std::string table = runFissure(folder, {"run", "s.yaml", "--force", "-o", "out.h5"}).out;
    EXPECT_EQ(table.find("\nfukuhara: " + warning) != std::string::npos, fine) << table;
  }
}

TEST(Run, NarrowRowsOnAnObliqueBladeAreWarnedOf) {
  const Folder folder;
  const auto narrow = [](const std::string& to) {
    return with(with(pressScenario("[{pipeline: fukuhara}]", "0.02"), "resolution: [4, 4]",
                     "resolution: [4, 4], narrow_rows: 2"),
                "move_to_m: [0, 0.052, 0]", "move_to_m: " + to);
  };
  for (const bool oblique : {false, true}) {
    folder.write("s.yaml", narrow(oblique ? "[0.01, 0.052, 0]" : "[0, 0.052, 0]"));
    for (const char* verb : {"validate", "plan"}) {
      const std::string said = runFissure(folder, {verb, "s.yaml"}).out;
      EXPECT_EQ(said.find("nodes.narrow_rows: the blade moves obliquely") != std::string::npos, oblique)
          << said;
    }
    const std::string table = runFissure(folder, {"run", "s.yaml", "--force", "-o", "out.h5"}).out;
    EXPECT_EQ(table.find("fukuhara: narrow_rows: in ") != std::string::npos, oblique) << table;
  }
}

std::string provenanceOf(const ResultInfo& info, const std::string& name) {
  for (const auto& [key, value] : info.provenance) {
    if (key == name) return value;
  }
  return "";
}

// Two workers, one result: single precision moves the tissue a little differently, and only a little.
TEST(Run, PrecisionIsAFieldOfAnEntry) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{name: double, pipeline: fukuhara}, "
                                       "{name: single, pipeline: fukuhara, precision: f32}]",
                                       "0.02", "record: {snapshots_every_s: 0.02}\n"));
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const ResultInfo info = readResultInfo(folder / "out.h5");
  EXPECT_EQ(provenanceOf(info, "engine_version"),
            "Bullet 3.24, double precision; Bullet 3.24, single precision");
  EXPECT_EQ(info.pipelines.at(1).precision, "f32");
  const auto positions = [&](const std::string& name) {
    return readSeries(folder / "out.h5", "/pipelines/" + name + "/positions").values;
  };
  const std::vector<double> exact = positions("double"), rounded = positions("single");
  ASSERT_EQ(exact.size(), rounded.size());
  ASSERT_FALSE(exact.empty());
  double largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) largest = std::max(largest, std::abs(exact[i] - rounded[i]));
  EXPECT_GT(largest, 1e-12) << "the same numbers: not another precision";
  EXPECT_LT(largest, 1e-3);
}

// Bullet's own pose matching draws a body of less than 32 mm radius to a point in single precision: the finer
// the mesh, the less its links resist (512 triangles: to 83 % of the extent).
TEST(Run, SinglePrecisionKeepsTheTissuesSize) {
  const Folder folder;
  const std::string fine = with(pressScenario("[{name: single, pipeline: \"null\", precision: f32}]", "0.02",
                                              "record: {snapshots_every_s: 0.02}\n"),
                                "subdivisions: 1", "subdivisions: 3");
  folder.write("s.yaml", with(fine, "settle_s: 0.005", "settle_s: 0.1"));
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const std::vector<double> positions_m = readSeries(folder / "out.h5", "/pipelines/single/positions").values;
  double least_m = 0, most_m = 0;
  for (std::size_t i = 0; i < positions_m.size(); i += 3) {
    least_m = std::min(least_m, positions_m[i]);
    most_m = std::max(most_m, positions_m[i]);
  }
  EXPECT_NEAR(most_m - least_m, 0.06, 0.001);
}

// Each entry of the table, by the worker of each precision.
TEST(Run, BothEnginesHaveEveryPipelineAndStoreItsDescription) {
  const Folder folder;
  std::string entries;
  std::vector<std::pair<const PipelineTraits*, std::string_view>> expected;
  for (const CatalogEntry& precision : catalog().precisions) {
    for (const PipelineTraits& pipeline : pipeline_table) {
      if (pipeline.detection == ContactDetection::volume) continue;  // of no shell
      const std::string name = std::string(pipeline.name) + "_" + std::string(precision.name);
      entries += (entries.empty() ? "" : ", ") + ("{name: " + name) + ", pipeline: \"" +
                 std::string(pipeline.name) + "\", precision: " + std::string(precision.name) + "}";
      expected.emplace_back(&pipeline, precision.name);
    }
  }
  folder.write("s.yaml", pressScenario("[" + entries + "]", "0.005"));
  const Outcome plan = runFissure(folder, {"plan", "s.yaml"});
  const Outcome run = runFissure(folder, {"run", "s.yaml", "-o", "out.h5"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const ResultInfo info = readResultInfo(folder / "out.h5");
  ASSERT_EQ(info.pipelines.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const PipelineResult& result = info.pipelines[i];
    EXPECT_EQ(result.pipeline, expected[i].first->name);
    EXPECT_EQ(result.description, expected[i].first->description);
    EXPECT_EQ(result.precision, expected[i].second);
    const std::string planned =
        "run " + result.name + " (" + result.pipeline + ", " + result.precision + ", at most";
    EXPECT_NE(plan.out.find(planned), std::string::npos) << planned << "\n" << plan.out;
  }
}

TEST(Run, ProvenanceNamesTheRendererOfFrames) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: cluster}]", "0.005",
                                       "record: {frames: {every_s: 0.005, size_px: [64, 48]}}\n"));
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "with.h5"}).code, 0);
  const ResultInfo drawn = readResultInfo(folder / "with.h5");
  EXPECT_NE(provenanceOf(drawn, "gl_version").find("Mesa"), std::string::npos);
  EXPECT_NE(provenanceOf(drawn, "gl_renderer"), "");
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "without.h5", "--no-frames"}).code, 0);
  EXPECT_EQ(provenanceOf(readResultInfo(folder / "without.h5"), "gl_version"), "");
}

TEST(Run, JsonSaysTheSameAsTheFile) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  const Outcome outcome = runFissure(folder, {"run", "s.yaml", "-o", "out.h5", "--json"});
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("exit_code"), 0);
  const nlohmann::json& pipeline = json.at("results").at(0).at("pipelines").at(0);
  EXPECT_EQ(pipeline.at("status"), "ok");
  const ResultInfo info = readResultInfo(folder / "out.h5");
  for (const SummaryValue& value : info.pipelines.at(0).summary) {
    const double* real = std::get_if<double>(&value.value);
    if (!real) continue;
    const nlohmann::json& said = pipeline.at("summary").at(value.name);
    EXPECT_TRUE(std::isfinite(*real) ? said == *real : said.is_null()) << value.name << ": " << said;
  }
  EXPECT_GT(pipeline.at("summary").at("timing/mean_step_us"), 0);
  const nlohmann::json again = nlohmann::json::parse(runFissure(folder, {"info", "out.h5", "--json"}).out);
  EXPECT_EQ(again, json.at("results").at(0));
}

TEST(Run, ForceReplaces) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  folder.write("out.h5", "old");
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5", "--force"}).code, 0);
  EXPECT_TRUE(readResultInfo(folder / "out.h5").complete);
  EXPECT_EQ(folder.names(), (Names{"out.h5", "s.yaml"}));
}

TEST(Run, SelectsPipelinesAndOverridesValues) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: default}, {pipeline: raycast}, {pipeline: fukuhara}]"));
  const Outcome outcome = runFissure(
      folder, {"run", "--pipeline", "fukuhara", "--pipeline", "default", "--set", "time.duration_s=0.01",
               "--set", "tools.spatula.nodes.resolution=[3, 3]", "-o", "out.h5", "s.yaml"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const ResultInfo info = readResultInfo(folder / "out.h5");
  ASSERT_EQ(info.pipelines.size(), 2u);
  EXPECT_EQ(info.pipelines[0].name, "default");
  EXPECT_EQ(info.pipelines[1].name, "fukuhara");
  const auto time = std::find_if(info.datasets.begin(), info.datasets.end(), [](const DatasetInfo& dataset) {
    return dataset.path == "/pipelines/fukuhara/time";
  });
  ASSERT_NE(time, info.datasets.end());
  EXPECT_EQ(time->shape, std::vector<unsigned long long>{11}) << "ten steps and the initial state";
  EXPECT_NE(info.scenario_resolved.find("0.01"), std::string::npos);
  EXPECT_EQ(info.scenario_resolved.find("raycast"), std::string::npos);
}

TEST(Run, SeveralScenariosSideBySide) {
  const Folder folder;
  folder.write("a.yaml",
               with(pressScenario("[{pipeline: default}, {pipeline: fukuhara}]"), "name: press", "name: a"));
  folder.write("b.yaml", with(pressScenario(), "name: press", "name: b"));
  const Outcome outcome = runFissure(folder, {"run", "a.yaml", "b.yaml", "-j", "2", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("results").size(), 2u);
  EXPECT_EQ(readResultInfo(folder / "out/a.h5").pipelines.size(), 2u);
  EXPECT_EQ(readResultInfo(folder / "out/b.h5").pipelines.size(), 1u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 2);
}

TEST(Run, ProvenanceNamesEverythingAndNoMachine) {
  const Folder folder;
  folder.write("base.yaml", pressScenario());
  folder.write("s.yaml", "base: base.yaml\nname: child\n");
  ASSERT_EQ(
      runFissure(folder, {"run", (folder / "s.yaml").string(), "-o", (folder / "out.h5").string()}).code, 0);
  const ResultInfo info = readResultInfo(folder / "out.h5");
  for (const char* name :
       {"version", "commit", "dirty", "scenario_hash", "input_hashes", "command_line", "started_utc",
        "ended_utc", "wall_time_s", "cpu_model", "cpu_count", "os", "compiler", "compiler_flags",
        "build_type", "hdf5_version", "yaml_cpp_version", "seed"})
    EXPECT_NE(provenanceOf(info, name), "") << name;
  EXPECT_EQ(provenanceOf(info, "command_line"), "fissure run s.yaml -o out.h5");
  const std::string inputs = provenanceOf(info, "input_hashes");
  for (const std::string name : {"s.yaml", "base.yaml"})
    EXPECT_NE(inputs.find(name + "=sha256:" + sha256(readInputFile(folder / name, "a file"))),
              std::string::npos)
        << inputs;
  EXPECT_EQ(provenanceOf(info, "scenario_hash"), "sha256:" + sha256(info.scenario_resolved));
  for (const auto& [name, value] : info.provenance)
    EXPECT_EQ(value.find(folder.path().string()), std::string::npos) << name << ": " << value;
  EXPECT_EQ(info.scenario_resolved.find(folder.path().string()), std::string::npos);
}

TEST(Run, TwoRunsIntoOneFileAreRefused) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario());
  Program first(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  ASSERT_GT(first.waitForWorker(), 0);
  const Outcome second = runFissure(folder, {"run", "s.yaml", "-o", "out.h5"});
  EXPECT_EQ(second.code, 2);
  EXPECT_EQ(second.err, "out.h5: is being written by another run\n");
}

TEST(Expect, DecidesTheExitCode) {
  const Folder folder;
  const auto run = [&](const std::string& expect, std::vector<std::string> more = {}) {
    folder.write("s.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.01", expect));
    more.insert(more.begin(), {"run", "s.yaml", "--force", "-o", "out.h5"});
    return runFissure(folder, more);
  };
  const Outcome good = run("expect: [{pipeline: fukuhara, quantity: steps, value: 10, tolerance: 0}]\n");
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_NE(good.out.find("expectations: 1 of 1 hold\n"), std::string::npos) << good.out;

  const std::string failing =
      "expect:\n"
      "  - {quantity: steps, value: 10, tolerance: 0}\n"
      "  - {pipeline: default, quantity: steps, max: 9}\n";
  const Outcome bad = run(failing);
  EXPECT_EQ(bad.code, 1);
  EXPECT_NE(bad.out.find("expectation failed: default: steps is 10, expected at most 9\n"), std::string::npos)
      << bad.out;
  EXPECT_NE(bad.out.find("expectations: 2 of 3 hold\n"), std::string::npos) << bad.out;
  EXPECT_NE(run(failing, {"--json"}).out.find("\"holds\": false"), std::string::npos);
  EXPECT_EQ(run(failing, {"--no-expect"}).code, 0);
  EXPECT_EQ(run(failing, {"--pipeline", "fukuhara"}).code, 0);  // what is not run is not expected
  // A run that fails is worse than an expectation that does.
  EXPECT_EQ(run(failing, {"--set", "pipelines.fukuhara.time_limit_s=0.001"}).code, 3);
}

TEST(Expect, IsReadWithTheScenario) {
  const Folder folder;
  folder.write("base.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.01",
                                          "expect: [{pipeline: default, quantity: steps, max: 9}]\n"));
  // An inherited list of expectations is replaced, not merged by pipeline.
  folder.write("s.yaml", "base: base.yaml\nexpect: [{pipeline: default, quantity: steps, min: 10}]\n");
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  folder.write("bad.yaml", "base: base.yaml\nexpect:\n  - {pipeline: defualt, quantity: steps, min: 10}\n");
  const Outcome bad = runFissure(folder, {"validate", "bad.yaml"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_EQ(bad.err,
            "bad.yaml:3: expect.0.pipeline is \"defualt\", which is no entry of pipelines, did you mean "
            "\"default\"?\n");
}

// stderr is no terminal: a run that ends at its time limit says nothing there.
TEST(Run, ProgressIsForTerminalsAlone) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario("[{pipeline: fukuhara, time_limit_s: 1}]"));
  const Outcome outcome = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "");
}

// stderr is a terminal of 100 columns: a line is rewritten in place, never longer than that, and gone at the
// end.
TEST(Run, ProgressLineOnATerminal) {
  const Folder folder;
  folder.write("s.yaml",
               pressScenario("[{pipeline: default}, {pipeline: fukuhara, time_limit_s: 1}]", "10000"));
  Program run(folder, {fissureProgram(), "run", "s.yaml", "--pipeline", "fukuhara"},
              {.file_bytes = {}, .error_is_terminal = true});
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("\r\x1b[K0/1 runs, fukuhara "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(" steps/s, "), std::string::npos);
  EXPECT_TRUE(outcome.err.ends_with("\r\x1b[K")) << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), std::string::npos);
  std::size_t longest = 0;
  for (std::size_t at = 0, next = 0; next != std::string::npos; at = next + 1) {
    next = outcome.err.find('\r', at);
    longest = std::max(longest, std::min(next, outcome.err.size()) - at);
  }
  EXPECT_LE(longest, 100 + 3u);
}

}  // namespace
}  // namespace fissure::programs::run_test
