#include "files/output_claim.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <climits>
#include <fstream>
#include <vector>

#include "base/error.h"
#include "files/temporary_file.h"

namespace fissure::output_claim_test {

namespace {

namespace fs = std::filesystem;

class Claims : public testing::Test {
 protected:
  Claims() {
    std::string name = (fs::temp_directory_path() / "fissure_claim_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Claims() override { fs::remove_all(folder_); }

  std::string complaintAbout(const std::string& name) const {
    try {
      const OutputClaim claim(folder_ / name, false);
    } catch (const InputError& error) {
      EXPECT_TRUE(error.isAbout(folder_ / name));
      return error.text();
    }
    return "nothing";
  }

  fs::path folder_;
};

// The longest name that is accepted leaves room for all that is made beside the result.
TEST_F(Claims, NamesLeaveRoomForTheFilesBeside) {
  const std::string ending = ".h5";
  std::size_t longest = 0;
  for (std::size_t bytes = 4; bytes <= NAME_MAX; ++bytes) {
    const std::string name = std::string(bytes - ending.size(), 'a') + ending;
    const std::string complaint = complaintAbout(name);
    if (complaint == "nothing")
      longest = bytes;
    else
      EXPECT_EQ(complaint.rfind("has a name of " + std::to_string(bytes) + " bytes, expected at most ", 0),
                0u);
  }
  ASSERT_GE(longest, 200u);
  ASSERT_LT(longest, std::size_t{NAME_MAX});
  const fs::path output = folder_ / (std::string(longest - ending.size(), 'a') + ending);
  const fs::path interrupted = fs::path(output).replace_extension(".interrupted.h5");
  constexpr int largest_process = 4194304, most_attempts = 1000;
  for (const fs::path& made : {hiddenBeside(output, ".XXXXXX"), hiddenBeside(interrupted, ".lock"),
                               TemporaryFile::nameFor(interrupted, largest_process, most_attempts)}) {
    std::ofstream(made).flush();
    EXPECT_TRUE(fs::exists(made)) << made;
  }
}

TEST_F(Claims, RemoveWhatKilledProcessesLeft) {
  const fs::path output = folder_ / "page.html";
  const std::vector<fs::path> others = {folder_ / "page.html.old.tmp", folder_ / "page.html.extra.1.0.tmp",
                                        TemporaryFile::nameFor(folder_ / "page.html.h5", 7, 0)};
  const std::vector<fs::path> left = {TemporaryFile::nameFor(output, 7, 0),
                                      TemporaryFile::nameFor(output, 4194304, 12)};
  for (const auto* files : {&others, &left})
    for (const fs::path& file : *files) std::ofstream(file).flush();
  EXPECT_EQ(complaintAbout("page.html"), "nothing");
  for (const fs::path& file : others) EXPECT_TRUE(fs::exists(file)) << file;
  for (const fs::path& file : left) EXPECT_FALSE(fs::exists(file)) << file;
}

}  // namespace
}  // namespace fissure::output_claim_test
