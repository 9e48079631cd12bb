#include "sweep/file_stamp.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/hash.h"
#include "files/temporary_folder.h"

namespace fissure::file_stamp_test {

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// Bytes that this process has read so far.
long long bytesRead() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  long long bytes = -1;
  counts >> name >> bytes;
  EXPECT_EQ(name, "rchar:");
  return bytes;
}

TEST(KnownHash, IsThatOfTheContentsAlsoWhenTheyHaveTheSameSizeAndTime) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a";
  EXPECT_EQ(knownHash(file), std::nullopt);
  write(file, "one");
  EXPECT_EQ(knownHash(file), "sha256:" + sha256("one"));
  const fs::file_time_type time = fs::last_write_time(file);
  const FileStamp stamp = stampOf(file);
  write(file, "two");
  fs::last_write_time(file, time);
  EXPECT_EQ(stampOf(file), stamp);
  EXPECT_EQ(knownHash(file), "sha256:" + sha256("two"));
  fs::remove(file);
  EXPECT_EQ(knownHash(file), std::nullopt);
  EXPECT_EQ(stampOf(file), FileStamp());
}

TEST(KnownHash, ReadsAFileOnceUnlessItIsWrittenAgain) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "large";
  constexpr int size = 1 << 20;
  write(file, std::string(size, 'a'));
  const long long before = bytesRead();
  const std::optional<std::string> hash = knownHash(file);
  const long long after = bytesRead();
  EXPECT_GE(after - before, size);
  EXPECT_EQ(knownHash(file), hash);
  EXPECT_LT(bytesRead() - after, size / 2);
}

}  // namespace

}  // namespace fissure::file_stamp_test
