#include "files/temporary_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <optional>

#include "base/error.h"

namespace fissure::temporary_folder_test {

namespace {

namespace fs = std::filesystem;

/// A $TMPDIR of a test's own.
class TemporaryFolders : public testing::Test {
 protected:
  TemporaryFolders() {
    std::string name = (fs::temp_directory_path() / "fissure_temporary_XXXXXX").string();
    among_ = ::mkdtemp(name.data());
    const char* const before = ::getenv("TMPDIR");
    if (before) before_ = before;
    ::setenv("TMPDIR", among_.c_str(), 1);
  }
  ~TemporaryFolders() override {
    if (before_)
      ::setenv("TMPDIR", before_->c_str(), 1);
    else
      ::unsetenv("TMPDIR");
    fs::remove_all(among_);
  }

  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(among_), {}));
  }

  fs::path among_;
  std::optional<std::string> before_;
};

TEST_F(TemporaryFolders, AreGoneWithAllThatIsInThem) {
  {
    const TemporaryFolder one, other;
    EXPECT_NE(one.path(), other.path());
    EXPECT_EQ(one.path().parent_path(), among_);
    fs::create_directory(one.path() / "inner");
    std::ofstream(one.path() / "inner/file") << "text";
    EXPECT_EQ(count(), 2u);
  }
  EXPECT_EQ(count(), 0u);
}

TEST_F(TemporaryFolders, OfKilledProcessesAreRemovedByTheNextAndNothingElseIs) {
  fs::path used;
  {
    const TemporaryFolder folder;
    used = folder.path();
  }
  fs::create_directory(used);  // as a killed process leaves it: nobody holds its lock
  std::ofstream(used / "surface.smesh") << "0";
  std::ofstream(among_ / "fissure-scratch-abcdef") << "a file of that name";
  fs::create_directory(among_ / "fissure-scratch-long");
  const TemporaryFolder one;
  EXPECT_FALSE(fs::exists(used));
  const TemporaryFolder other;
  EXPECT_TRUE(fs::exists(one.path())) << "it is in use";
  EXPECT_TRUE(fs::exists(among_ / "fissure-scratch-abcdef"));
  EXPECT_TRUE(fs::exists(among_ / "fissure-scratch-long"));
}

TEST_F(TemporaryFolders, ThatCannotBeMadeAreAnErrorWithItsReason) {
  ::setenv("TMPDIR", (among_ / "missing").c_str(), 1);
  EXPECT_THROW(TemporaryFolder(), RunError);
}

}  // namespace
}  // namespace fissure::temporary_folder_test
