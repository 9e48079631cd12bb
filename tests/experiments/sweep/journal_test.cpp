#include "sweep/journal.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>

#include "base/error.h"
#include "task/task_record.h"

namespace fissure::journal_test {

namespace {

namespace fs = std::filesystem;

class JournalTest : public testing::Test {
 protected:
  JournalTest() : folder_(fs::path(testing::TempDir()) / ("fissure_journal_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
  }
  ~JournalTest() override { fs::remove_all(folder_); }

  std::vector<std::string> records(std::size_t* damaged = nullptr) const {
    std::vector<std::string> found;
    Journals journals(folder_);
    journals.each([&](const std::string& record, const JournalPlace& place) {
      EXPECT_EQ(journals.read(place, 0, record.size() + 10), record);
      EXPECT_EQ(journals.read(place, 1, 2), record.empty() ? "" : record.substr(1, 2));
      found.push_back(record);
    });
    if (damaged) *damaged = journals.damaged().size();
    return found;
  }

  fs::path folder_;
};

const std::string binary("\0FSR1\xff\n", 7);

TEST_F(JournalTest, HoldsWhatWasAppendedInOrder) {
  EXPECT_TRUE(records().empty());  // no folder
  {
    JournalWriter writer(folder_);
    for (const std::string& record : {std::string("one"), std::string(), binary, std::string(3000000, 'x')})
      writer.append(record);
    writer.sync(0);
    EXPECT_EQ(records().size(), 4u);  // while its writer lives
  }
  std::size_t damaged = 9;
  const std::vector<std::string> found = records(&damaged);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0], "one");
  EXPECT_EQ(found[2], binary);
  EXPECT_EQ(found[3].size(), 3000000u);
  EXPECT_EQ(damaged, 0u);
}

TEST_F(JournalTest, WhatItsWriterHasNotFinishedIsNoDamage) {
  const JournalWriter writer(folder_);
  std::ofstream(writer.path(), std::ios::app) << "FSR10000";
  std::size_t damaged = 9;
  EXPECT_TRUE(records(&damaged).empty());
  EXPECT_EQ(damaged, 0u);
}

TEST_F(JournalTest, WithNothingInItIsGone) {
  { const JournalWriter writer(folder_); }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(JournalTest, CutAnywhereItKeepsItsWholeRecords) {
  fs::path file;
  {
    JournalWriter writer(folder_);
    for (const char* record : {"first", "second", "third"}) writer.append(record);
    file = writer.path();
  }
  const auto whole = static_cast<std::size_t>(fs::file_size(file));
  const std::size_t first = 36 + 5, second = first + 36 + 6;
  for (std::size_t size = whole; size-- > 0;) {
    fs::resize_file(file, size);
    std::size_t damaged = 0;
    EXPECT_EQ(records(&damaged).size(), size >= second ? 2u : size >= first ? 1u : 0u) << size;
    EXPECT_EQ(damaged, size == 0 || size == first || size == second ? 0u : 1u) << size;
  }
}

TEST_F(JournalTest, AnyByteThatIsChangedIsNoticed) {
  fs::path file;
  {
    JournalWriter writer(folder_);
    writer.append("first");
    writer.append("second");
    file = writer.path();
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  for (std::size_t at = 36 + 5; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x15);
    std::ofstream(file, std::ios::binary) << changed;
    std::size_t damaged = 0;
    EXPECT_EQ(records(&damaged), std::vector<std::string>{"first"}) << at;
    EXPECT_EQ(damaged, 1u) << at;
  }
}

TEST_F(JournalTest, AFullDiskIsSaidAndLeavesWholeRecords) {
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = {};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  {
    JournalWriter writer(folder_);
    writer.append(std::string(1000, 'a'));
    const rlimit small = {2000, limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(writer.append(std::string(5000, 'b')), RunError);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    writer.append("after");
  }
  std::signal(SIGXFSZ, before);
  std::size_t damaged = 9;
  EXPECT_EQ(records(&damaged), (std::vector<std::string>{std::string(1000, 'a'), "after"}));
  EXPECT_EQ(damaged, 0u);
}

TEST_F(JournalTest, LeftoversOfTheDeadAreRemovedAndOfTheLivingNot) {
  JournalWriter living(folder_);
  living.append("one");
  fs::create_directory(folder_ / "dead.work");
  std::ofstream(folder_ / "killed.journal") << "";
  fs::create_directory(folder_ / "killed.work");
  fs::create_directory(folder_ / "other.work");
  for (const char* ours : {"dead.work", "killed.work"})
    fs::copy(living.work() / "machine", folder_ / ours / "machine");
  std::ofstream(folder_ / "other.work" / "machine") << "another machine\n";
  std::ofstream(folder_ / "other.journal") << "";
  std::ofstream(folder_ / "unnamed.starting") << "";
  std::ofstream(folder_ / "killed.work" / "3.part") << "half a part";
  {
    const JournalWriter another(folder_);
    EXPECT_TRUE(fs::is_directory(another.work()));
  }
  EXPECT_TRUE(fs::is_directory(living.work()));
  EXPECT_TRUE(fs::exists(living.path()));
  EXPECT_FALSE(fs::exists(folder_ / "dead.work"));
  EXPECT_FALSE(fs::exists(folder_ / "killed.work"));
  EXPECT_FALSE(fs::exists(folder_ / "killed.journal"));
  EXPECT_FALSE(fs::exists(folder_ / "unnamed.starting"));
  EXPECT_TRUE(fs::exists(folder_ / "other.work"));  // its lock may not be seen here
  EXPECT_TRUE(fs::exists(folder_ / "other.journal"));
}

TEST(TaskRecords, KeepEveryBit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TaskNumbers numbers{{"a_m", "b_N"}, 2, {1.0 / 3, nan, -0.0, 1e-320}, {nan, 5}, {{"hash", "x\ny"}}};
  const std::string bytes = encodeNumbers(numbers);
  const TaskNumbers back = decodeNumbers(bytes);
  EXPECT_EQ(encodeNumbers(back), bytes);
  EXPECT_EQ(back.names, numbers.names);
  EXPECT_EQ(back.values[0], 1.0 / 3);
  EXPECT_TRUE(std::isnan(back.values[1]) && std::signbit(back.values[2]));
  EXPECT_EQ(back.values[3], 1e-320);
  EXPECT_EQ(back.texts.at("hash"), "x\ny");

  TaskRecord record;
  record.task = "0123";
  record.status = {RunEnd::non_finite, "at step 3"};
  record.numbers = bytes;
  record.timing = {{"timing/x_us", 2.5}};
  record.file = "runs/a.h5";
  record.file_bytes = 12;
  record.file_time = 34;
  record.recorded_s = 56;
  const TaskRecord read = decodeRecord(encodeRecord(record));
  EXPECT_EQ(encodeRecord(read), encodeRecord(record));
  EXPECT_EQ(read.numbers, bytes);
  EXPECT_TRUE(read.finished());
  record.status.end = RunEnd::crashed;
  EXPECT_FALSE(record.finished());
  EXPECT_THROW(decodeRecord("nonsense"), RunError);
  EXPECT_THROW(decodeRecord(""), RunError);
  EXPECT_THROW(decodeNumbers(bytes.substr(0, bytes.size() / 2)), RunError);
}

}  // namespace
}  // namespace fissure::journal_test
