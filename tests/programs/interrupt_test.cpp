// Runs that are stopped, killed or starved: nothing finished is lost, nothing half made is kept.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <csignal>

#include "program.h"
#include "scenarios.h"
#include "store/result_file.h"

namespace fissure::programs::interrupt_test {
namespace {

using Names = std::vector<std::string>;

// Two runs of which the first ends soon and the second takes hours: only their motions' pipelines differ, so
// the first is made short by its wall-clock limit where a test needs no result, and by a scenario of its own
// where it does.

class Stopped : public testing::TestWithParam<int> {};

TEST_P(Stopped, BeforeAnyRunWasFinished) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario("[{pipeline: default}, {pipeline: fukuhara}]"));
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  const pid_t worker = run.waitForWorker();
  ASSERT_GT(worker, 0);
  run.send(GetParam());
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_TRUE(endsSoon(worker));
  EXPECT_EQ(folder.names(), Names{"s.yaml"}) << "no result, no parts, no lock";
}

INSTANTIATE_TEST_SUITE_P(Signals, Stopped, testing::Values(SIGINT, SIGTERM, SIGHUP));

// Scenario a is finished when b's endless run is under way; c was not started.
TEST(Interrupted, FinishedScenariosAreKept) {
  const Folder folder;
  folder.write("a.yaml", with(pressScenario(), "name: press", "name: a"));
  folder.write("b.yaml", with(endlessScenario(), "name: press", "name: b"));
  folder.write("c.yaml", with(pressScenario(), "name: press", "name: c"));
  Program run(folder, {fissureProgram(), "run", "a.yaml", "b.yaml", "c.yaml"});
  const pid_t first = run.waitForWorker();
  ASSERT_GT(first, 0);
  while (!std::filesystem::exists(folder / "out/a.h5")) ASSERT_GT(run.waitForWorker(), 0);
  ASSERT_GT(run.waitForWorker(first), 0);
  run.send(SIGINT);
  EXPECT_EQ(run.wait().code, 130);
  EXPECT_TRUE(readResultInfo(folder / "out/a.h5").complete);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 1);
}

// Two entries of half a second or more: the request comes when the second has begun.
TEST(Interrupted, FinishedPipelinesOfAScenarioAreKept) {
  const Folder folder;
  folder.write("s.yaml",
               pressScenario("[{name: a, pipeline: fukuhara}, {name: b, pipeline: fukuhara}]", "4"));
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  const pid_t first = run.waitForWorker();
  ASSERT_GT(first, 0);
  ASSERT_GT(run.waitForWorker(first), 0);
  run.send(SIGINT);
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(folder.names(), (Names{"out.h5", "s.yaml"}));
  const ResultInfo info = readResultInfo(folder / "out.h5");
  EXPECT_TRUE(info.complete);
  ASSERT_EQ(info.pipelines.size(), 2u);
  EXPECT_EQ(nameOf(info.pipelines[0].status.end), "ok");
  EXPECT_EQ(nameOf(info.pipelines[1].status.end), "interrupted");
}

// With --force an older, whole result is not given up for a part of a newer one.
TEST(Interrupted, AnOlderResultIsLeftAlone) {
  const Folder folder;
  const std::string entries = "[{name: a, pipeline: fukuhara}, {name: b, pipeline: fukuhara}]";
  folder.write("s.yaml", pressScenario(entries, "4"));
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5", "--set", "time.duration_s=0.01"}).code, 0);
  const std::string older = folder.read("out.h5");
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5", "--force"});
  const pid_t first = run.waitForWorker();
  ASSERT_GT(first, 0);
  ASSERT_GT(run.waitForWorker(first), 0);
  run.send(SIGINT);
  EXPECT_EQ(run.wait().code, 130);
  EXPECT_EQ(folder.names(), (Names{"out.h5", "out.interrupted.h5", "s.yaml"}));
  EXPECT_EQ(folder.read("out.h5"), older);
  EXPECT_EQ(nameOf(readResultInfo(folder / "out.interrupted.h5").pipelines[0].status.end), "ok");
}

// Workers read a log for themselves: one that changes under way may have given them different motions.
TEST(Inputs, ChangedWhileTheRunsGoOnFailThem) {
  const Folder folder;
  folder.write("s.yaml",
               pressScenario("[{name: a, pipeline: fukuhara}, {name: b, pipeline: fukuhara}]", "1"));
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  ASSERT_GT(run.waitForWorker(), 0);
  folder.write("s.yaml", "something else\n");
  EXPECT_EQ(run.wait().code, 3);
  const ResultInfo info = readResultInfo(folder / "out.h5");
  ASSERT_EQ(info.pipelines.size(), 2u);
  EXPECT_EQ(nameOf(info.pipelines[1].status.end), "failed");
  EXPECT_NE(info.pipelines[1].status.detail.find("changed"), std::string::npos);
}

TEST(Killed, WorkerIsACrashAndTheOthersGoOn) {
  const Folder folder;
  folder.write("s.yaml",
               pressScenario("[{name: a, pipeline: fukuhara}, {name: b, pipeline: fukuhara}]", "4"));
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  const pid_t worker = run.waitForWorker();
  ASSERT_GT(worker, 0);
  ::kill(worker, SIGKILL);
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.out.find("a: crashed: killed by signal 9 (SIGKILL)"), std::string::npos) << outcome.out;
  EXPECT_EQ(folder.names(), (Names{"out.h5", "s.yaml"}));
  const ResultInfo info = readResultInfo(folder / "out.h5");
  ASSERT_EQ(info.pipelines.size(), 2u);
  EXPECT_EQ(nameOf(info.pipelines[0].status.end), "crashed");
  EXPECT_EQ(nameOf(info.pipelines[1].status.end), "ok");
}

TEST(Killed, FrontTakesItsWorkerAlongAndLeavesNoResult) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario());
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  const pid_t worker = run.waitForWorker();
  ASSERT_GT(worker, 0);
  run.send(SIGKILL);
  EXPECT_EQ(run.wait().signal, SIGKILL);
  EXPECT_TRUE(endsSoon(worker));
  EXPECT_FALSE(std::filesystem::exists(folder / "out.h5"));
  // The next run into this file is neither stopped by what was left behind nor leaves it.
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5", "--set", "time.duration_s=0.01"}).code, 0);
  EXPECT_EQ(folder.names(), (Names{"out.h5", "s.yaml"}));
}

TEST(TimeLimit, IsRecorded) {
  const Folder folder;
  folder.write("s.yaml", endlessScenario("[{pipeline: fukuhara, time_limit_s: 3}]"));
  const Outcome outcome = runFissure(folder, {"run", "s.yaml", "-o", "out.h5"});
  EXPECT_EQ(outcome.code, 3);
  const ResultInfo info = readResultInfo(folder / "out.h5");
  EXPECT_EQ(nameOf(info.pipelines.at(0).status.end), "timeout");
  EXPECT_NE(info.pipelines.at(0).status.detail.find("time limit of 3 s reached after step "),
            std::string::npos)
      << info.pipelines.at(0).status.detail;
}

/// Exit code 3, and no file but a whole result in which the run has failed.
void expectFailedCleanly(const Outcome& outcome, const Folder& folder, const std::string& place) {
  EXPECT_EQ(outcome.code, 3) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err.find("HDF5"), std::string::npos)
      << outcome.err << "a library's own messages are no use";
  const std::filesystem::path result = folder / (place + "out.h5");
  for (const auto& entry : std::filesystem::directory_iterator(result.parent_path()))
    EXPECT_TRUE(entry.path().filename() == "out.h5" || entry.path().filename() == "s.yaml") << entry.path();
  if (!std::filesystem::exists(result)) return;
  const ResultInfo info = readResultInfo(result);
  EXPECT_TRUE(info.complete);
  const RunStatus& status = info.pipelines.at(0).status;
  EXPECT_EQ(nameOf(status.end), "failed") << status.detail;
  EXPECT_NE(status.detail, "");
  EXPECT_EQ(status.detail.find('/'), std::string::npos) << status.detail << ": a folder of this machine";
}

const std::string many_snapshots = "record: {snapshots_every_s: 0.001}\n";

TEST(FullDisk, FileSizeLimit) {
  const Folder folder;
  folder.write("s.yaml", pressScenario("[{pipeline: fukuhara}]", "1", many_snapshots));
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", (folder / "out.h5").string()},
              {.file_bytes = 250000, .error_is_terminal = false});
  expectFailedCleanly(run.wait(), folder, "");
}

TEST(FullDisk, SmallFileSystem) {
  const Folder folder;
  std::filesystem::create_directory(folder / "small");
  if (::mount("tmpfs", (folder / "small").c_str(), "tmpfs", 0, "size=300k") != 0)
    GTEST_SKIP() << "mounting a small file system needs more rights than this test has";
  folder.write("s.yaml", pressScenario("[{pipeline: fukuhara}]", "1", many_snapshots));
  expectFailedCleanly(runFissure(folder, {"run", "s.yaml", "-o", "small/out.h5"}), folder, "small/");
  ::umount((folder / "small").c_str());
}

TEST(FullDisk, StandardOutput) {
  const Folder folder;
  const Outcome outcome =
      runTool(folder, {"sh", "-c", "exec \"$1\" list > /dev/full", "sh", fissureProgram()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "standard output: cannot write: No space left on device\n");
}

}  // namespace
}  // namespace fissure::programs::interrupt_test
