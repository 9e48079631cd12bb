#include "slurm/sbatch_options.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/error.h"

namespace fissure::sbatch_options_test {

namespace {

using Words = std::vector<std::string>;

std::string refusal(const Words& options) {
  try {
    refuseUnfitOptions(options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool expects(const Words& options, const std::string& what) {
  return refusal(options).find(what) != std::string::npos;
}

TEST(SbatchOptions, ThatChooseTheArrayAreRefusedInEverySpelling) {
  for (const char* word :
       {"-a", "-a1-5", "-Ha1-5", "--ar", "--arr=1-5", "--arra=1", "--array", "--array=1-5"})
    EXPECT_TRUE(expects({word, "1-5"}, "expected --shards")) << word;
  EXPECT_EQ(refusal({"--account=a", "-Aa", "--acctg-freq=30", "-pa", "-Hpa", "--argh=1"}), "");
}

TEST(SbatchOptions, ThatBreakASweepAreRefused) {
  for (const char* word : {"-c", "-c4", "--cpus-per-t=4", "--cpus-per-task=4"})
    EXPECT_TRUE(expects({word}, "expected -j")) << word;
  for (const char* word : {"-M", "-Mb", "--cl=b", "--cluster", "--clusters=b"})
    EXPECT_TRUE(expects({word}, "of one cluster")) << word;
  for (const char* word : {"-W", "-HW", "--wait"})
    EXPECT_TRUE(expects({word}, "expected no waiting")) << word;
  EXPECT_EQ(refusal({"--cpus-per-gpu=4", "--wait-all-nodes=1", "-C", "c", "--cluster-constraint=x"}), "");
}

TEST(SbatchOptions, MayAlsoStandInTheEnvironment) {
  ::setenv("SBATCH_CLUSTERS", "b", 1);
  EXPECT_TRUE(expects({}, "SBATCH_CLUSTERS is set: the queue"));
  ::unsetenv("SBATCH_CLUSTERS");
  EXPECT_EQ(refusal({}), "");
}

TEST(SbatchOptions, AreNoScript) {
  const std::string file = std::filesystem::read_symlink("/proc/self/exe").string();
  EXPECT_EQ(refusal({"-p", "all", "--comment", "", "-A", "x"}), "");
  EXPECT_TRUE(expects({"other.sbatch"}, "is no option"));
  EXPECT_TRUE(expects({"-p", "all", "other.sbatch"}, "other.sbatch: is no option"));
  EXPECT_TRUE(expects({"--partition=all", "other.sbatch"}, "is no option"));
  EXPECT_TRUE(expects({"-p", "all", "--"}, "is no option"));
  EXPECT_TRUE(expects({"-p", "all", "-"}, "is no option"));
  EXPECT_TRUE(expects({"--exclusive", file}, "expected it behind a ="));
  EXPECT_EQ(refusal({"--nodefile=" + file}), "");
}

TEST(SbatchOptions, NameAnOutput) {
  for (const char* word : {"-o", "-ox", "-Hox", "--ou=x", "--output=x"})
    EXPECT_TRUE(nameOutput({"-p", "a", word}));
  EXPECT_FALSE(nameOutput({"-p", "o", "--oversubscribe", "-O", "--open-mode=append"}));
}

}  // namespace
}  // namespace fissure::sbatch_options_test
