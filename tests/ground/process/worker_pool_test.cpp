#include "process/worker_pool.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <stdexcept>

#include "shell_pool.h"

namespace fissure::worker_pool_test {

namespace {

TEST(WorkerPool, RunsAllTasksSideBySideAsAllowed) {
  const std::vector<WorkerTask> tasks(5, shellTask("sleep 0.1"));
  const Listener one = runPool(tasks, 1);
  EXPECT_EQ(one.side_by_side, 1);
  EXPECT_EQ(one.starts, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  const Listener three = runPool(tasks, 3);
  EXPECT_EQ(three.side_by_side, 3);
  EXPECT_EQ(three.starts.size(), 5u);
}

TEST(WorkerPool, NoTasksIsNothing) {
  EXPECT_TRUE(runPool({}, 2).starts.empty());
}

TEST(WorkerPool, OneBadWorkerLeavesTheOthersAlone) {
  Listener heard = runPool({shellTask("kill -ABRT $$"), shellTask("exit 0"), shellTask("sleep 9", 0.2),
                            WorkerTask{"/nowhere", {}, 1}, shellTask("exit 0")},
                           2);
  EXPECT_EQ(nameOf(heard.ends[0].end), "crashed");
  EXPECT_EQ(nameOf(heard.ends[1].end), "ok");
  EXPECT_EQ(nameOf(heard.ends[2].end), "timeout");
  EXPECT_EQ(nameOf(heard.ends[3].end), "failed");
  EXPECT_EQ(nameOf(heard.ends[4].end), "ok");
}

// Asking every 5 ms, as of systems that do not tell, would be about 60 times.
TEST(WorkerPool, IsToldWhenASilentWorkerEnds) {
  class Counting : public Listener {
   public:
    void woke() override { ++wakes; }
    int wakes = 0;
  };
  Interrupt interrupt;
  Counting heard;
  WorkerPool(1, interrupt).run({shellTask("exec >&- 2>&-; sleep 0.3")}, heard);
  EXPECT_EQ(nameOf(heard.ends[0].end), "ok");
  EXPECT_GE(heard.wakes, 1);
  EXPECT_LT(heard.wakes, 15);
}

// What the machine is to blame for is told apart from how runs end, where somebody listens to that.
TEST(WorkerPool, TellsAHinderedTaskFromOneThatFails) {
  class Apart : public Listener {
   public:
    void hindered(std::size_t task, const std::string& reason) override { reasons[task] = reason; }
    std::map<std::size_t, std::string> reasons;
  };
  Interrupt interrupt;
  Apart heard;
  const std::string unwritten = "echo 'error: no room' >&2; exit " + std::to_string(exit_unwritten);
  WorkerPool(1, interrupt)
      .run({shellTask(unwritten), shellTask("exit 3"), WorkerTask{"/nowhere", {}, 1}, shellTask("exit 0")},
           heard);
  ASSERT_EQ(heard.reasons.size(), 2u);
  EXPECT_EQ(heard.reasons[0], "no room");
  EXPECT_EQ(heard.reasons[2], "cannot start nowhere: No such file or directory");
  EXPECT_EQ(nameOf(heard.ends[1].end), "failed");
  EXPECT_EQ(nameOf(heard.ends[3].end), "ok");
  EXPECT_EQ(endOf(shellTask(unwritten)), "failed|no room");
}

// The second of four workers sends the request to its parent, which is this test, and goes on: it and the
// rest stop.
class Interrupted : public testing::TestWithParam<const char*> {};

TEST_P(Interrupted, RequestStopsWorkersAndKeepsWhatIsFinished) {
  const std::string signal = GetParam();
  const auto start = std::chrono::steady_clock::now();
  Listener heard =
      runPool({shellTask("exit 0"), shellTask("echo progress 4 8; kill -" + signal + " $PPID; sleep 30"),
               shellTask("exit 0"), shellTask("exit 0")});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(nameOf(heard.ends[0].end), "ok");
  EXPECT_EQ(nameOf(heard.ends[1].end), "interrupted");
  EXPECT_EQ(heard.ends[1].detail, "stopped after step 4 of 8");
  for (const std::size_t task : {2u, 3u}) {
    EXPECT_EQ(nameOf(heard.ends[task].end), "interrupted");
    EXPECT_EQ(heard.ends[task].detail, "not started");
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values("INT", "TERM", "HUP"));

TEST(Interrupt, RemembersARequestAndRestoresTheSignals) {
  sigset_t before;
  sigprocmask(SIG_SETMASK, nullptr, &before);
  {
    Interrupt interrupt;
    EXPECT_FALSE(interrupt.requested());
    raise(SIGINT);
    EXPECT_TRUE(interrupt.requested());
    EXPECT_TRUE(interrupt.requested());
    raise(SIGTERM);  // forgotten by the destructor; else it would end this test program
  }
  sigset_t after;
  sigprocmask(SIG_SETMASK, nullptr, &after);
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    EXPECT_EQ(sigismember(&before, number), sigismember(&after, number));
}

TEST(Interrupt, IgnoredSignalsStayIgnored) {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  {
    Interrupt interrupt;
    raise(SIGHUP);
    EXPECT_FALSE(interrupt.requested());
  }
  std::signal(SIGHUP, before);
}

TEST(WorkerPool, WhatTheObserverThrowsStopsTheWorkers) {
  class Thrower : public Listener {
   public:
    void finished(std::size_t, const RunStatus&) override { throw std::runtime_error("disk full"); }
  } thrower;
  Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(WorkerPool(2, interrupt).run({shellTask("exec sleep 30", 60), shellTask("exit 0")}, thrower),
               std::runtime_error);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace fissure::worker_pool_test
