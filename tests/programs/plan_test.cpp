// `fissure plan --pilot`: how long runs will take, seen from outside.
#include <gtest/gtest.h>

#include <csignal>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::plan_test {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

/// Words that run fissure in a folder with its own place for temporary files, "tmp".
Names words(const Folder& folder, const Names& verb) {
  fs::create_directory(folder / "tmp");
  Names all = {"env", "TMPDIR=" + (folder / "tmp").string(), fissureProgram()};
  all.insert(all.end(), verb.begin(), verb.end());
  return all;
}

std::ptrdiff_t temporaryFiles(const Folder& folder) {
  return std::distance(fs::directory_iterator(folder / "tmp"), {});
}

TEST(Pilot, PlanSaysHowLongEachRunTakesAndKeepsNothing) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "1",
                                       "record: {snapshots_every_s: 0.01}\n"));
  const Outcome plan = runTool(folder, words(folder, {"plan", "s.yaml", "--pilot", "10"}));
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_EQ(plan.err, "");
  std::size_t lines = 0;
  for (std::size_t at = 0; (at = plan.out.find("\n  time: ", at)) != std::string::npos; ++at) ++lines;
  EXPECT_EQ(lines, 2u) << plan.out;
  EXPECT_TRUE(hasMatch(plan.out,
                       "^  time: (about )?[0-9.]+ s( to [0-9.]+ s)? \\(pilot of (9[0-9]|100) of 1000 steps "
                       "took [0-9.]+ s\\)$"))
      << plan.out;
  EXPECT_FALSE(hasMatch(plan.out, "time: (about )?(0.00 s|-|nan|inf)")) << plan.out;
  EXPECT_EQ(temporaryFiles(folder), 0);
  EXPECT_EQ(folder.names(), (Names{"s.yaml", "tmp"}));
  EXPECT_EQ(runTool(folder, words(folder, {"plan", "s.yaml"})).out.find("time: "), std::string::npos)
      << "nothing is simulated unless it is asked for";
}

TEST(Pilot, ReplaysAreThinnedToo) {
  const Folder folder;
  const Outcome plan =
      runTool(folder, words(folder, {"plan", FISSURE_SOURCE_DIR "/configs/replay_tracker.yaml", "--pilot",
                                     "20", "--no-frames", "--pipeline", "fukuhara"}));
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_TRUE(hasMatch(plan.out, "^  time: .* \\(pilot of [0-9]+ of [0-9]+ steps took [0-9.]+ s\\)$"))
      << plan.out;
}

TEST(Pilot, BadNumbersAreRefused) {
  const Folder folder;
  folder.write("s.yaml", pressScenario());
  for (const char* number : {"0", "1", "-3", "1001", "ten", "2.5", ""}) {
    const Outcome plan = runFissure(folder, {"plan", "s.yaml", "--pilot", number});
    EXPECT_EQ(plan.code, 2) << number;
    EXPECT_TRUE(isOneLine(plan.err)) << plan.err;
  }
}

TEST(Pilot, OneThatFailsSaysWhy) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario("[{pipeline: fukuhara, time_limit_s: 3}]"));
  const Outcome plan = runTool(folder, words(folder, {"plan", "s.yaml", "--pilot", "10"}));
  EXPECT_EQ(plan.code, 3);
  EXPECT_TRUE(
      hasMatch(plan.out, "^  time: unknown, the pilot timeout: time limit of 3 s reached after step "))
      << plan.out;
  EXPECT_EQ(temporaryFiles(folder), 0);
}

TEST(Pilot, ARequestToStopLeavesNothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Folder folder;
    folder.write("s.yaml", endlessScenario());
    Program plan(folder, words(folder, {"plan", "s.yaml", "--pilot", "2"}));
    const pid_t worker = plan.waitForWorker();
    ASSERT_GT(worker, 0);
    plan.send(signal);
    EXPECT_EQ(plan.wait().code, 130);
    EXPECT_TRUE(endsSoon(worker));
    EXPECT_EQ(temporaryFiles(folder), 0);
  }
}

TEST(Pilot, WhatAKilledOneLeavesTheNextOneRemoves) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario());
  Program plan(folder, words(folder, {"plan", "s.yaml", "--pilot", "2"}));
  const pid_t worker = plan.waitForWorker();
  ASSERT_GT(worker, 0);
  plan.send(SIGKILL);
  plan.wait();
  EXPECT_TRUE(endsSoon(worker));
  folder.write("s.yaml", pressScenario());
  EXPECT_EQ(runTool(folder, words(folder, {"plan", "s.yaml", "--pilot", "2"})).code, 0);
  EXPECT_EQ(temporaryFiles(folder), 0);
}

}  // namespace
}  // namespace fissure::programs::plan_test
