#include "files/input_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"

namespace fissure::input_file_test {

namespace {

namespace fs = std::filesystem;

class InputFiles : public testing::Test {
 protected:
  InputFiles() {
    std::string name = (fs::temp_directory_path() / "fissure_input_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    ::alarm(60);  // reading a pipe or a device would never end
  }
  ~InputFiles() override {
    ::alarm(0);
    fs::remove_all(folder_);
  }

  static std::string complaintAbout(const fs::path& file, std::uintmax_t most_bytes = UINTMAX_MAX) {
    try {
      readInputFile(file, "a mesh", most_bytes);
    } catch (const InputError& error) {
      EXPECT_TRUE(error.isAbout(file));
      return error.text();
    }
    return "nothing";
  }

  fs::path folder_;
};

TEST_F(InputFiles, AreReadWhole) {
  std::string bytes("a\0b\r\n", 5);
  bytes.append(3000000, 'x');
  std::ofstream(folder_ / "whole", std::ios::binary) << bytes;
  EXPECT_EQ(readInputFile(folder_ / "whole", "a mesh"), bytes);
  std::ofstream(folder_ / "empty").flush();
  EXPECT_EQ(readInputFile(folder_ / "empty", "a mesh"), "");
}

TEST_F(InputFiles, OtherKindsAreRefusedBeforeTheyAreOpened) {
  EXPECT_EQ(complaintAbout(folder_ / "none"), "no such file, expected a mesh");
  EXPECT_EQ(complaintAbout(folder_), "is a folder, expected a mesh");
  EXPECT_EQ(complaintAbout("/dev/zero"), "is no regular file, expected a mesh");
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(complaintAbout(pipe), "is no regular file, expected a mesh");
  EXPECT_THROW(requireInputFile(pipe, "a mesh"), InputError);
  fs::create_symlink(pipe, folder_ / "link");
  EXPECT_EQ(complaintAbout(folder_ / "link"), "is no regular file, expected a mesh");
  fs::create_symlink(folder_ / "loop", folder_ / "loop");
  EXPECT_EQ(complaintAbout(folder_ / "loop").rfind("cannot be read (", 0), 0u);
}

// The file is sparse: what matters is the size that it has, and none of it is read.
TEST_F(InputFiles, LargerOnesAreRefused) {
  std::ofstream(folder_ / "large").flush();
  fs::resize_file(folder_ / "large", (std::uintmax_t{3} << 20) + 1);
  EXPECT_EQ(complaintAbout(folder_ / "large", std::uintmax_t{3} << 20),
            "is larger than 3 MiB, expected a mesh of at most 3 MiB");
  fs::resize_file(folder_ / "large", std::uintmax_t{3} << 20);
  EXPECT_EQ(complaintAbout(folder_ / "large", std::uintmax_t{3} << 20), "nothing");
}

// Files of /proc have no size, and reading /proc/kmsg waits for the kernel's next line.
TEST_F(InputFiles, WithoutASizeTheyAreEmpty) {
  EXPECT_EQ(readInputFile("/proc/self/environ", "a text"), "");
  if (::access("/proc/kmsg", R_OK) == 0) {
    EXPECT_EQ(readInputFile("/proc/kmsg", "a text"), "");
  }
}

}  // namespace
}  // namespace fissure::input_file_test
