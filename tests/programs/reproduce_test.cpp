// scripts/reproduce takes its numbers, and its verdicts, from the runs.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::reproduce_test {
namespace {

TEST(Reproduce, ThePageFollowsTheNumbers) {
  const std::string python = pythonWith("xarray, h5py, matplotlib");
  if (python.empty()) GTEST_SKIP() << "no python3 with xarray, h5py and matplotlib here";
  const Folder folder;
  folder.write("s.yaml", fullScenario());
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "a.h5"}).code, 0);
  const Outcome outcome = runTool(folder, {python, FISSURE_SOURCE_DIR "/tests/programs/reproduce_test.py",
                                           FISSURE_SOURCE_DIR "/scripts", "a.h5"});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace fissure::programs::reproduce_test
