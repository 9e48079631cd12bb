#include "process/fed_process.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>

#include "base/error.h"

namespace fissure::fed_process_test {

namespace {

namespace fs = std::filesystem;

const std::vector<std::uint8_t> megabyte(1000000, 'x');

class FedProcessTest : public testing::Test {
 protected:
  FedProcessTest() { std::signal(SIGPIPE, SIG_IGN); }
  ~FedProcessTest() override { std::signal(SIGPIPE, SIG_DFL); }
};

/// `script` gets `argument` as $1.
void feed(const std::string& script, const std::string& argument = "", int times = 1, int stop = -1) {
  FedProcess shell("/bin/sh", {"-c", script, "sh", argument}, stop);
  for (int i = 0; i < times; ++i) shell.write(megabyte);
  shell.finish();
}

// It reads nothing after its first bytes, so that the pipe fills.
TEST_F(FedProcessTest, OneThatTakesNothingIsGivenUp) {
  FedProcess shell("/bin/sh", {"-c", "exec sleep 1000"}, -1, 1);
  const auto feed_it = [&] {
    for (int i = 0; i < 10; ++i) shell.write(megabyte);
  };
  EXPECT_THROW(feed_it(), RunError);
  EXPECT_THROW(shell.finish(), RunError);
}

std::string failureOf(const std::string& script, int times = 1) {
  try {
    feed(script, "", times);
  } catch (const RunError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(FedProcessTest, GetsEveryByteInOrder) {
  const fs::path file = fs::temp_directory_path() / ("fissure_fed_" + std::to_string(::getpid()));
  std::vector<std::uint8_t> bytes(3000000);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  FedProcess shell("/bin/sh", {"-c", "cat > \"$1\"", "sh", file.string()}, -1);
  shell.write({bytes.data(), 7});
  shell.write({bytes.data() + 7, bytes.size() - 7});
  shell.finish();
  std::ifstream stream(file, std::ios::binary);
  const std::string got((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_TRUE(std::equal(got.begin(), got.end(), bytes.begin(), bytes.end(),
                         [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }));
  fs::remove(file);
}

TEST_F(FedProcessTest, ArgumentsPassNoShell) {
  EXPECT_NO_THROW(feed("cat > /dev/null; test \"$1\" = 'a b;`id`*'", "a b;`id`*"));
}

TEST_F(FedProcessTest, ItsLastLineSaysWhatWentWrong) {
  EXPECT_EQ(failureOf("echo first >&2; printf 'the last' >&2; exit 3"), "sh: the last");
  EXPECT_EQ(failureOf("cat > /dev/null; echo late >&2; exit 3"), "sh: late");
  EXPECT_EQ(failureOf("exit 3"), "sh: exit code 3 without a word");
  EXPECT_EQ(failureOf("kill -9 $$"), "sh: killed by signal 9");
}

TEST_F(FedProcessTest, AnErrorIsAFailureWhateverTheExitCode) {
  EXPECT_EQ(failureOf("cat > /dev/null; echo disk full >&2"), "sh: disk full");
}

// Both pipes full: whoever only writes waits for ever.
TEST_F(FedProcessTest, FloodsOfWordsDoNotHoldIt) {
  EXPECT_EQ(failureOf("i=0; while [ $i -lt 3000 ]; do printf '%01000d\\n' $i; printf '%0100d\\n' $i >&2; "
                      "i=$((i + 1)); done; cat > /dev/null",
                      3)
                .substr(0, 10),
            "sh: 000000");
}

TEST_F(FedProcessTest, WaitingForAProgramThatTakesNothingCanBeStopped) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  ASSERT_EQ(::write(ends[1], "x", 1), 1);
  EXPECT_THROW(feed("sleep 1000", "", 1, ends[0]), RunError);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_F(FedProcessTest, OneThatIsNotThereIsAnError) {
  EXPECT_THROW(FedProcess("/nowhere/ffmpeg", {}, -1), RunError);
}

TEST(ProgramOnPath, IsTheFirstThatCanBeRun) {
  const std::string before = ::getenv("PATH");
  ::setenv("PATH", "/nonexistent:/etc:/bin", 1);
  EXPECT_EQ(programOnPath("sh"), fs::path("/bin/sh"));
  EXPECT_EQ(programOnPath("passwd-"), std::nullopt) << "no program";
  ::setenv("PATH", "/nonexistent", 1);
  EXPECT_EQ(programOnPath("sh"), std::nullopt);
  ::setenv("PATH", before.c_str(), 1);
}

}  // namespace
}  // namespace fissure::fed_process_test
