#include "process/system_program.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

#include "base/error.h"
#include "process/interrupt.h"

namespace fissure::system_program_test {

namespace {

ProgramOutcome shell(const std::string& script, double most_s = 60) {
  return runProgram("/bin/sh", {"-c", script, "sh", "a b"}, most_s);
}

TEST(SystemProgram, SaysWhatItPrintedAndHowItEnded) {
  const ProgramOutcome outcome = shell("echo \"$1\"; echo one >&2; echo two >&2; echo >&2; exit 7");
  EXPECT_TRUE(outcome.in_time);
  EXPECT_EQ(outcome.code, 7);
  EXPECT_EQ(outcome.output, "a b\n");
  EXPECT_EQ(outcome.error, "two");
  EXPECT_EQ(shell("exit 0").error, "");
}

TEST(SystemProgram, MayPrintMoreThanAPipeHolds) {
  EXPECT_EQ(shell("head -c 1000000 /dev/zero").output.size(), 1000000u);
}

TEST(SystemProgram, HasNothingToRead) {
  EXPECT_EQ(shell("cat").output, "");
}

TEST(SystemProgram, ThatDoesNotAnswerIsEnded) {
  const auto start = std::chrono::steady_clock::now();
  const ProgramOutcome outcome = shell("echo so far; echo waits >&2; exec sleep 60", 0.5);
  EXPECT_FALSE(outcome.in_time);
  EXPECT_EQ(outcome.output, "so far\n");
  EXPECT_EQ(outcome.error, "waits");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(SystemProgram, IsEndedWhenItsStarterIsAskedToStop) {
  const auto start = std::chrono::steady_clock::now();
  const RequestsHeldBack held_back;
  const Descriptor requests = heldBackRequests();
  const auto wait = [&] {
    runProgram("/bin/sh", {"-c", "kill -TERM $PPID; exec sleep 60"}, 60, requests.number());
  };
  EXPECT_THROW(wait(), Interrupted);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  Interrupt owner;
  EXPECT_TRUE(owner.requested()) << "the request is left to whoever deals with it";
}

TEST(SystemProgram, ThatASignalEndsIsAnError) {
  try {
    shell("kill -9 $$");
    ADD_FAILURE();
  } catch (const KilledProgram& killed) {
    EXPECT_EQ(killed.signal(), SIGKILL);
    EXPECT_STREQ(killed.what(), "sh: killed by signal 9");
  }
  EXPECT_THROW(runProgram("/nowhere/program", {}, 1), RunError);
}

}  // namespace
}  // namespace fissure::system_program_test
