#include "process/tool.h"

#include <gtest/gtest.h>

#include <chrono>

#include "base/error.h"

namespace fissure::tool_test {

namespace {

ToolOutcome shell(const std::string& script, double most_s = 60) {
  return runTool("/bin/sh", {"-c", script, "sh", "a b"}, most_s);
}

TEST(Tool, SaysWhatItPrintedAndHowItEnded) {
  const ToolOutcome outcome = shell("echo \"$1\"; echo one >&2; echo two >&2; echo >&2; exit 7");
  EXPECT_TRUE(outcome.in_time);
  EXPECT_EQ(outcome.code, 7);
  EXPECT_EQ(outcome.output, "a b\n");
  EXPECT_EQ(outcome.error, "two");
  EXPECT_EQ(shell("exit 0").error, "");
}

TEST(Tool, MayPrintMoreThanAPipeHolds) {
  EXPECT_EQ(shell("head -c 1000000 /dev/zero").output.size(), 1000000u);
}

TEST(Tool, HasNothingToRead) {
  EXPECT_EQ(shell("cat").output, "");
}

TEST(Tool, ThatDoesNotAnswerIsEnded) {
  const auto start = std::chrono::steady_clock::now();
  const ToolOutcome outcome = shell("echo so far; echo waits >&2; exec sleep 60", 0.5);
  EXPECT_FALSE(outcome.in_time);
  EXPECT_EQ(outcome.output, "so far\n");
  EXPECT_EQ(outcome.error, "waits");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Tool, ThatASignalEndsIsAnError) {
  EXPECT_THROW(shell("kill -9 $$"), RunError);
  EXPECT_THROW(runTool("/nowhere/tool", {}, 1), RunError);
}

}  // namespace
}  // namespace fissure::tool_test
