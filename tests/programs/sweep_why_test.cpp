// `fissure sweep --why` from outside: what it says before and after runs, and that it runs and writes
// nothing.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "scenarios.h"
#include "sweeps.h"

namespace fissure::programs::sweep_why_test {
namespace {

namespace fs = std::filesystem;

const std::string masses = "axes: [{path: bodies.sphere.mass_kg, values: [0.1, 0.11]}]\n";

TEST(SweepWhy, SaysWhatWouldRunAndRunsNothing) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf(masses));
  const Outcome fresh = runFissure(folder, {"sweep", "s.yaml", "-o", "out", "--why"});
  EXPECT_EQ(fresh.code, 0) << fresh.err;
  EXPECT_TRUE(hasMatch(fresh.out,
                       "[0-9a-f]{16}  fukuhara  bodies.sphere.mass_kg=0.1   no record of it\n"
                       "[0-9a-f]{16}  fukuhara  bodies.sphere.mass_kg=0.11  no record of it\n"
                       "to run: 2 of 2 simulations\n$"))
      << fresh.out;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"press.yaml", "s.yaml"}));
  ASSERT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out"}).code, 0);
  for (const char* named : {"s.yaml", "out"}) {  // the file, or the folder
    std::vector<std::string> words = {"sweep", named, "--why"};
    if (words[1] == "s.yaml") words.insert(words.end(), {"-o", "out"});
    const Outcome done = runFissure(folder, words);
    EXPECT_EQ(done.code, 0);
    EXPECT_TRUE(hasMatch(done.out, "finished: ok\n.*finished: ok\nto run: 0 of 2 simulations\n$"))
        << done.out;
  }
}

TEST(SweepWhy, SaysWhatChangedSinceThePlan) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf(masses));
  ASSERT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out"}).code, 0);
  folder.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "0.02"));
  const std::string plan = folder.read("out/manifest.json");
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "out", "--why", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder.read("out/manifest.json"), plan);
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json.at("why").size(), 2u);
  EXPECT_EQ(json.at("why").at(0).at("text"), "changed: time.duration_s");
  EXPECT_EQ(json.at("why").at(0).at("why"), "changed");
  EXPECT_NE(outcome.err.find("2 records of an earlier form of the sweep"), std::string::npos) << outcome.err;
}

TEST(SweepWhy, FailuresShardsAndLostResults) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf("axes: [{path: time.duration_s, values: [0.01, 1000]}]\nkeep: results\n"
                                 "limits: {time_s: 3}\n"));
  ASSERT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out"}).code, 3);
  const Outcome failed = runFissure(folder, {"sweep", "out", "--why"});
  EXPECT_EQ(failed.code, 0);
  EXPECT_TRUE(hasMatch(failed.out, "=0.01 +finished: ok\n.*tried again: timeout \\(time limit of 3 s"))
      << failed.out;
  fs::remove_all(folder / "out/runs");
  EXPECT_TRUE(hasMatch(runFissure(folder, {"sweep", "out", "--why"}).out,
                       "lost: runs/[0-9a-f]{16}.h5 is gone or damaged\n"));
  const Outcome shard = runFissure(folder, {"sweep", "out", "--why", "--shard", "1/2"});
  EXPECT_TRUE(hasMatch(shard.out, "not here: of shard 2/2\n")) << shard.out;
  EXPECT_TRUE(hasMatch(shard.out, "to run: 1 of 2 simulations\n")) << shard.out;
}

TEST(SweepWhy, WithADryRunItSaysHowLongToo) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf(masses));
  const Outcome both = runFissure(folder, {"sweep", "s.yaml", "-o", "out", "--why", "--dry-run", "--json"});
  EXPECT_EQ(both.code, 0) << both.err;
  const auto json = nlohmann::json::parse(both.out);
  EXPECT_EQ(json.at("unfinished_simulations"), 2);
  EXPECT_EQ(json.at("why").size(), 2u);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(SweepWhy, RefusesWhatARunWould) {
  const Folder folder;
  folder.write("press.yaml", pressScenario());
  folder.write("s.yaml", sweepOf(masses));
  fs::create_directory(folder / "mine");
  folder.write("mine/thesis.txt", "do not touch");
  const Outcome outcome = runFissure(folder, {"sweep", "s.yaml", "-o", "mine", "--why"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_EQ(outcome.err.find("mine: is no folder of a sweep"), 0u) << outcome.err;
}

/// A closed surface of eight triangles.
std::string octahedron(double radius_m) {
  std::string text;
  for (const double sign : {1.0, -1.0})
    for (const char* axis : {"v {} 0 0\n", "v 0 {} 0\n", "v 0 0 {}\n"})
      text += with(axis, "{}", std::to_string(sign * radius_m));
  return text + "f 1 2 3\nf 2 4 3\nf 4 5 3\nf 5 1 3\nf 2 1 6\nf 4 2 6\nf 5 4 6\nf 1 5 6\n";
}

TEST(SweepWhy, OfFilesOnAnAxisOnlyTheChangedOneRunsAgain) {
  const Folder folder;
  folder.write("press.yaml", with(pressScenario(), "{type: sphere, radius_m: 0.03, subdivisions: 1}",
                                  "{type: file, file: a.obj, unit: m}"));
  folder.write("a.obj", octahedron(0.03));
  folder.write("b.obj", octahedron(0.031));
  folder.write("s.yaml", sweepOf("axes:\n"
                                 "  - {path: bodies.sphere.shape.file, values: [a.obj, b.obj]}\n"
                                 "  - {path: bodies.sphere.mass_kg, values: [0.1, 0.11]}\n"));
  const Outcome first = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string table = folder.read("out/sweep.csv");
  folder.write("b.obj", octahedron(0.032));
  const Outcome refused = runFissure(folder, {"sweep", "out"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.err, "out: was planned with another b.obj, expected its sweep file to plan it again\n");
  EXPECT_TRUE(hasMatch(runFissure(folder, {"sweep", "s.yaml", "-o", "out", "--why"}).out,
                       "=a.obj, bodies.sphere.mass_kg=0.1   finished: ok\n.*=a.obj, .*finished: ok\n"
                       ".*=b.obj, .*changed: another b.obj\n.*=b.obj, .*changed: another b.obj\n"
                       "to run: 2 of 4 simulations\n"));
  ASSERT_EQ(runFissure(folder, {"sweep", "s.yaml", "-o", "out"}).code, 0);
  const std::string changed = folder.read("out/sweep.csv");
  const auto rowsOfA = [](const std::string& csv) { return csv.substr(0, csv.find("\n2,")); };
  EXPECT_NE(changed, table);
  EXPECT_EQ(rowsOfA(changed), rowsOfA(table));
  fs::remove(folder / "b.obj");
  const Outcome gone = runFissure(folder, {"sweep", "s.yaml", "-o", "out"});
  EXPECT_EQ(gone.code, 2);
  EXPECT_TRUE(
      hasMatch(gone.err, "^s.yaml:5: axis bodies.sphere.shape.file: .*: no such file, expected a mesh\n$"))
      << gone.err;
  EXPECT_EQ(folder.read("out/sweep.csv"), changed);
}

}  // namespace
}  // namespace fissure::programs::sweep_why_test
