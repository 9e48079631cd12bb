#include "process/apart.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <vector>

#include "process/interrupt.h"

namespace fissure::apart_test {

namespace {

const Allowance allowance{.processor_s = 10};

InputError comesBack(const InputError& error) {
  try {
    doApart([&] { throw error; }, allowance);
  } catch (const InputError& came) {
    return came;
  }
  return InputError("nothing");
}

TEST(Apart, ErrorsKeepTheirFields) {
  for (const Origin& origin :
       {Origin(), inFile("a b.yaml", 7), ofOverride("tools.0.x"), ofAxis("force.hc.k", "sweep.yaml", 12)}) {
    const InputError back = comesBack({origin, "is wrong, expected: right"});
    EXPECT_EQ(back.origin().kind, origin.kind);
    EXPECT_EQ(back.origin().file, origin.file);
    EXPECT_EQ(back.origin().line, origin.line);
    EXPECT_EQ(back.origin().path, origin.path);
    EXPECT_EQ(back.text(), "is wrong, expected: right");
    EXPECT_EQ(back.what(), origin.beginning() + "is wrong, expected: right");
  }
  EXPECT_STREQ(comesBack(InputError("")).what(), "");
}

TEST(Apart, OtherErrorsAndEndsAreToldApart) {
  EXPECT_NO_THROW(doApart([] {}, allowance));
  try {
    doApart([] { throw std::logic_error("broken"); }, allowance);
    FAIL() << "nothing came back";
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "broken");
  }
  EXPECT_THROW(doApart([] { ::raise(SIGKILL); }, allowance), LostApart);
}

TEST(Apart, AReaderThatFailsIsADamagedFile) {
  try {
    tryReading("a.stl", [] { throw RunError("ends too early"); });
    FAIL() << "nothing came back";
  } catch (const InputError& error) {
    EXPECT_TRUE(error.isAbout("a.stl"));
    EXPECT_EQ(error.text(), "a damaged file (ends too early)");
  }
}

/// Waits for ever, as a reader does that has opened a pipe.
void waitForEver() {
  for (;;) ::pause();
}

TEST(Apart, OneThatOnlyWaitsIsKilledByTheClock) {
  EXPECT_THROW(doApart(waitForEver, {.processor_s = 0, .waiting_s = 1}), LostApart);
}

// What a process says costs none of the time in which it is waited for.
TEST(Apart, ALongOutcomeComesBackWhole) {
  const std::string text(1000000, 'x');
  try {
    doApart([&] { throw RunError(text); }, {.processor_s = 1, .waiting_s = 1});
    FAIL() << "nothing came back";
  } catch (const RunError& error) {
    EXPECT_TRUE(error.what() == text) << std::string(error.what()).substr(0, 80);
  }
}

TEST(Apart, OneThatTakesTooMuchMemoryFails) {
  const auto take = [] {
    if (std::vector<char>(std::size_t{1} << 28, 'x').back() != 'x') throw std::logic_error("not filled");
  };
  EXPECT_NO_THROW(doApart(take, {.processor_s = 60, .memory_bytes = std::uint64_t{1} << 30}));
  EXPECT_THROW(doApart(take, {.processor_s = 60, .memory_bytes = std::uint64_t{1} << 26}), RunError);
}

TEST(Apart, ARequestThatIsHeldBackEndsItUnlessAResultWouldBeLost) {
  ::alarm(60);
  Interrupt interrupt;
  EXPECT_NO_THROW(doApart([] {}, allowance));
  ::raise(SIGTERM);
  EXPECT_THROW(doApart(waitForEver, allowance), Interrupted);
  EXPECT_THROW(tryReading("a.stl", waitForEver), Interrupted) << "not a damaged file";
  EXPECT_NO_THROW(tryReadingOwn("a.stl", [] {}));
  EXPECT_TRUE(interrupt.requested()) << "its owner has yet to notice it";
  EXPECT_NO_THROW(doApart([] {}, allowance)) << "noticed: what is to be done after it goes on";
  ::alarm(0);
}

/// Whether a process of that number is there and no zombie.
bool lives(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return stat >> number >> name >> state && state != "Z";
}

// The front is a child of the test; the process apart tells its own number.
TEST(Apart, DiesWithItsFront) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t front = ::fork();
  if (front == 0) {
    doApart(
        [&] {
          const pid_t own = ::getpid();
          if (::write(ends[1], &own, sizeof own) == sizeof own) waitForEver();
        },
        allowance);
    ::_exit(0);
  }
  pid_t apart = 0;
  ASSERT_EQ(::read(ends[0], &apart, sizeof apart), static_cast<ssize_t>(sizeof apart));
  EXPECT_TRUE(lives(apart));
  ::kill(front, SIGKILL);
  ::waitpid(front, nullptr, 0);
  for (int i = 0; i < 500 && lives(apart); ++i) ::usleep(10000);
  EXPECT_FALSE(lives(apart));
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace
}  // namespace fissure::apart_test
