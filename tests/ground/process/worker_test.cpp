#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "process/worker_pool.h"
#include "shell_pool.h"

namespace fissure::worker_test {

namespace {

namespace fs = std::filesystem;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Worker, ExitCodeZeroIsOk) {
  EXPECT_EQ(endOf(shellTask("exit 0")), "ok|");
}

TEST(Worker, ArgumentsPassNoShell) {
  const std::string nasty = "a b;'\"$HOME`id`\\ *";
  EXPECT_EQ(endOf(shellTask("printf 'error: %s\\n' \"$1\" >&2; exit 2", 20, nasty)), "failed|" + nasty);
}

TEST(Worker, ErrorLineOfAFailureIsKept) {
  EXPECT_EQ(endOf(shellTask("echo noise >&2; echo 'error: disk full' >&2; echo more >&2; exit 3")),
            "failed|disk full");
  EXPECT_EQ(endOf(shellTask("printf 'error: no line end' >&2; exit 3")), "failed|no line end");
}

TEST(Worker, FailureWithoutErrorLineSaysCodeAndStep) {
  EXPECT_EQ(endOf(shellTask("echo progress 7 9; echo first >&2; echo last >&2; exit 5")),
            "failed|exit code 5 after step 7 of 9: last");
  EXPECT_EQ(endOf(shellTask("exit 127")), "failed|exit code 127 before its first step");
}

TEST(Worker, SignalIsACrashWithNameAndStep) {
  EXPECT_EQ(endOf(shellTask("echo progress 12 500; kill -SEGV $$")),
            "crashed|killed by signal 11 (SIGSEGV) after step 12 of 500");
  EXPECT_EQ(endOf(shellTask("kill -9 $$")), "crashed|killed by signal 9 (SIGKILL) before its first step");
}

TEST(Worker, MissingProgramFails) {
  EXPECT_EQ(endOf({"/nowhere/fissure-engine-f64", {}, 1}),
            "failed|cannot start fissure-engine-f64: No such file or directory");
}

TEST(Worker, TimeLimitKills) {
  std::string end;
  const double wall_s = seconds([&] { end = endOf(shellTask("echo progress 3 10; exec sleep 30", 0.3)); });
  EXPECT_EQ(end, "timeout|time limit of 0.3 s reached after step 3 of 10");
  EXPECT_GE(wall_s, 0.3);
  EXPECT_LT(wall_s, 5);
}

TEST(Worker, TimeLimitHoldsAgainstAFlood) {
  EXPECT_EQ(endOf(shellTask("exec yes 'no progress at all'", 0.3)).substr(0, 8), "timeout|");
}

// 50 MB without one line end, then a true line: the front must find it, and must not have kept the rest.
TEST(Worker, GarbageNeitherConfusesNorFills) {
  rusage before = {};
  getrusage(RUSAGE_SELF, &before);
  const Listener heard =
      runPool({shellTask("head -c 50000000 /dev/zero | tr '\\0' x; echo; head -c 200000 /dev/urandom; echo; "
                         "echo 'progress 9 5'; echo progress 5 10; echo 'progress 1 2 3'; "
                         "head -c 50000000 /dev/zero >&2")});
  rusage after = {};
  getrusage(RUSAGE_SELF, &after);
  EXPECT_EQ(nameOf(heard.ends.at(0).end), "ok");
  EXPECT_EQ(heard.last.at(0), (Progress{5, 10}));
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 20000) << "kB";
}

// seq writes whole blocks, so one wake-up finds hundreds of lines.
TEST(Worker, ProgressIsHeardAtMostOnceAWakeUp) {
  const Listener heard = runPool({shellTask("seq -f 'progress %.0f 20000' 1 20000")});
  EXPECT_EQ(heard.last.at(0), (Progress{20000, 20000}));
  EXPECT_LT(heard.calls, 2000);
}

TEST(Worker, ClosedPipesAreNoEnd) {
  EXPECT_EQ(endOf(shellTask("exec >&- 2>&-; sleep 0.3; exit 4")), "failed|exit code 4 before its first step");
}

TEST(Worker, AProcessItLeavesBehindIsNotWaitedFor) {
  EXPECT_LT(seconds([] { EXPECT_EQ(endOf(shellTask("sleep 3 & exit 0")), "ok|"); }), 2.5);
}

TEST(Worker, ControlCharactersOfItsErrorAreReplaced) {
  EXPECT_EQ(endOf(shellTask("printf 'error: a\\033[2Jb\\377\\n' >&2; exit 3")), "failed|a?[2Jb?");
}

TEST(Worker, InheritsNeitherDescriptorsNorSignals) {
  const int leaked = ::open("/dev/null", O_RDONLY);  // without O_CLOEXEC
  ASSERT_GE(leaked, 3);
  EXPECT_EQ(endOf(shellTask("[ -e /proc/$$/fd/$1 ] && exit 1; exit 0", 20, std::to_string(leaked))), "ok|");
  ::close(leaked);
  EXPECT_EQ(endOf(shellTask("read -r line; [ -z \"$line\" ] || exit 1")), "ok|") << "stdin is empty";
  EXPECT_EQ(endOf(shellTask("while read -r key value; do "
                            "[ \"$key\" = SigBlk: ] && [ \"$value\" != 0000000000000000 ] && exit 1; "
                            "done </proc/self/status; exit 0")),
            "ok|")
      << "no signal is blocked";
  EXPECT_EQ(endOf(shellTask("kill -INT $$; kill -TERM $$; kill -HUP $$; exit 0")), "ok|")
      << "a Ctrl-C at the terminal reaches the whole group, but the front decides";
}

/// True when no process has this id within two seconds. A zombie, whose new parent has not reaped it, counts
/// as gone.
bool disappears(pid_t process) {
  for (int i = 0; i < 200; ++i) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    const std::size_t end = text.rfind(')');
    if (end == std::string::npos || text.substr(end).starts_with(") Z")) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(Worker, DiesWithItsFront) {
  const fs::path note = fs::path(testing::TempDir()) / ("worker-" + std::to_string(::getpid()));
  const pid_t front = ::fork();
  ASSERT_GE(front, 0);
  if (front == 0) {
    Interrupt interrupt;
    Listener listener;
    WorkerPool(1, interrupt)
        .run({shellTask("echo $$ > \"$1.new\" && mv \"$1.new\" \"$1\"; exec sleep 60", 60, note.string())},
             listener);
    ::_exit(0);
  }
  pid_t worker = 0;
  for (int i = 0; i < 500 && worker == 0; ++i) {
    std::ifstream(note) >> worker;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_GT(worker, 0);
  ::kill(front, SIGKILL);
  ::waitpid(front, nullptr, 0);
  EXPECT_TRUE(disappears(worker));
  fs::remove(note);
}

}  // namespace
}  // namespace fissure::worker_test
