// What is asked of Slurm's programs, played by scripts, and what becomes of their answers.
#include "slurm/slurm.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "base/error.h"

namespace fissure::slurm_test {

namespace {

namespace fs = std::filesystem;

class SlurmAnswers : public testing::Test {
 protected:
  SlurmAnswers() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    ::setenv("PATH", (folder_.string() + ":" + path_).c_str(), 1);
  }
  ~SlurmAnswers() override {
    ::setenv("PATH", path_.c_str(), 1);
    ::unsetenv("SBATCH_ARRAY_INX");
    fs::remove_all(folder_);
  }
  void tool(const std::string& name, const std::string& script) const {
    std::ofstream(folder_ / name) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(folder_ / name, fs::perms::owner_all);
  }
  static std::string refusal(double most_s = 60) {
    try {
      return submitJob({"x"}, most_s);
    } catch (const RunError& error) {
      return error.what();
    }
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("fissure_slurm_" + std::to_string(::getpid()));
  std::string path_ = std::getenv("PATH");
};

TEST_F(SlurmAnswers, AnIdMayHaveACluster) {
  tool("sbatch", "echo '77;alpha'");
  EXPECT_EQ(submitJob({"x"}), "77");
}

TEST_F(SlurmAnswers, AJobIsNotForgottenWhenItsProgramTakesTooLong) {
  tool("sbatch", "echo 77; exec sleep 60");
  EXPECT_EQ(submitJob({"x"}, 1.5), "77");
  tool("sbatch", "printf 7; exec sleep 60");
  EXPECT_EQ(refusal(0.5),
            "sbatch: no answer within 0.5 s; the job may be queued all the same, squeue says that");
}

TEST_F(SlurmAnswers, NoJobIsAnArrayByTheEnvironment) {
  ::setenv("SBATCH_ARRAY_INX", "1-5", 1);
  tool("sbatch", "echo ${SBATCH_ARRAY_INX:-42}");
  EXPECT_EQ(submitJob({"x"}), "42");
}

TEST_F(SlurmAnswers, TooManyJobsAreFewerShards) {
  tool("sbatch",
       "echo 'sbatch: error: AssocMaxSubmitJobLimit' >&2\n"
       "echo 'sbatch: error: Batch job submission failed: Job violates accounting/QOS policy (job submit "
       "limit, "
       "user'\\''s size and/or time limits)' >&2\nexit 1");
  EXPECT_NE(refusal().find("limits); if these are too many jobs at a time: fewer tasks with --shards N"),
            std::string::npos)
      << refusal();
  tool("sbatch", "echo 'sbatch: error: invalid partition' >&2; exit 1");
  EXPECT_EQ(refusal(), "sbatch: error: invalid partition");
}

TEST_F(SlurmAnswers, TheLimitOfJobsIsTheLeastOfAssociationsAndDefaultQos) {
  tool("sacctmgr",
       "case \"$*\" in *assoc*) printf '|normal\\n200|\\n300|long\\n';; *name=normal,long*) echo 50; echo;; "
       "esac");
  EXPECT_EQ(submitLimit(), 50u);
  tool("sacctmgr", "case \"$*\" in *assoc*) printf '200|normal\\n300|\\n';; *) echo;; esac");
  EXPECT_EQ(submitLimit(), 200u);
  tool("sacctmgr", "echo '|'");
  EXPECT_EQ(submitLimit(), std::nullopt);
  tool("sacctmgr", "echo '5|'; exit 1");
  EXPECT_EQ(submitLimit(), std::nullopt);
  tool("sacctmgr", "echo '5|'; exec sleep 60");
  EXPECT_EQ(submitLimit(0.5), std::nullopt);
}

TEST_F(SlurmAnswers, AClusterMayTakeNoArrays) {
  tool("scontrol", "echo 'MaxArraySize            = 1'; echo 'MaxJobCount             = 10000'");
  EXPECT_THROW(slurmLimits(), InputError);
  tool("scontrol", "echo 'MaxArraySize            = 2'; echo 'MaxJobCount             = 10000'");
  EXPECT_EQ(slurmLimits().mostShards(), 1u);
}

struct Configured {
  std::string config;            ///< what scontrol prints, as printf takes it
  std::optional<int> job_count;  ///< nothing: refused
};

TEST_F(SlurmAnswers, ALimitIsANumberOfUpToNineDigitsOnALineOfItsOwn) {
  const std::vector<Configured> all = {
      {"MaxJobCount=10", 10},
      {"a = b\\nMaxJobCount \\t =  10 \\t\\r\\nc = d\\n", 10},
      {"MaxJobCount\\n=\\n10\\n", 10},
      {"MaxJobCount = 999999999\\n", 999999999},
      {"MaxJobCount = 0000000010\\n", {}},
      {"MaxJobCount = 10 (of 20)\\n", {}},
      {"MaxJobCount = 10s\\n", {}},
      {"MaxJobCount = -10\\n", {}},
      {"MaxJobCount = \\n", {}},
      {"MaxJobCount : 10\\n", {}},
      {" MaxJobCount = 10\\n", {}},
      {"OtherMaxJobCount = 10\\n", {}},
      {"MaxJobCounts = 10\\n", {}},
      {"MaxJobCount = many\\nMaxJobCount = 10\\n", 10},
      {"MaxJobCount = 5\\nMaxJobCount = 10\\n", 5},
  };
  for (const Configured& each : all) {
    tool("scontrol", "printf '" + each.config + "'; printf '\\nMaxArraySize = 1001\\n'");
    try {
      EXPECT_EQ(slurmLimits().max_job_count, static_cast<std::size_t>(each.job_count.value_or(-1)))
          << each.config;
    } catch (const RunError& error) {
      EXPECT_FALSE(each.job_count) << each.config;
      EXPECT_STREQ(error.what(), "scontrol: says no MaxJobCount");
    }
  }
}

}  // namespace
}  // namespace fissure::slurm_test
