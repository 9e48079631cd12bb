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

}  // namespace
}  // namespace fissure::programs::sweep_why_test
