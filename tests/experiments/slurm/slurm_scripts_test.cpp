#include "slurm/slurm_scripts.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace fissure::slurm_scripts_test {

namespace {

const ArrayScript script = {"blades", 24, 4, 2, "'/opt/my programs/fissure'", "%2"};

std::string without(std::string text, const std::string& what) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? "test error: no " + what : text.erase(at, what.size());
}

TEST(SlurmScripts, SayAgainWhatTheyWereMadeOf) {
  const ArrayScript read = readArrayScript(arrayScriptText(script), "f");
  EXPECT_EQ(read.sweep, script.sweep);
  EXPECT_EQ(read.simulations, script.simulations);
  EXPECT_EQ(read.shards, script.shards);
  EXPECT_EQ(read.cpus, script.cpus);
  EXPECT_EQ(read.program, script.program);
  EXPECT_EQ(read.throttle, script.throttle);
  EXPECT_EQ(arrayScriptText(read), arrayScriptText(script));
}

TEST(SlurmScripts, GetAnotherNumberOfShardsWhereverTheyWereEdited) {
  const std::string edited = "#!/bin/bash -x\n" + arrayScriptText(script) + "echo done\n";
  ArrayScript other = script;
  other.shards = 7;
  other.simulations = 100;
  EXPECT_EQ(withShards(edited, other), "#!/bin/bash -x\n" + arrayScriptText(other) + "echo done\n");
  EXPECT_EQ(withShards(edited, script), edited);
}

TEST(SlurmScripts, AreRefusedWithoutALineThatIsNeeded) {
  for (const char* line : {"#SBATCH --array=1-4", "\nshards=4", "\nprogram=", "#SBATCH --cpus-per-task=2",
                           "# Sweep blades: 24 simulations"}) {
    EXPECT_THROW(readArrayScript(without(arrayScriptText(script), line), "f"), InputError) << line;
  }
  EXPECT_THROW(readArrayScript(arrayScriptText(script).replace(arrayScriptText(script).find("--array=1-4%"),
                                                               12, "--array=1-9%"),
                               "f"),
               InputError)
      << "other tasks than shards";
  ArrayScript none = script;
  none.shards = 0;
  EXPECT_THROW(readArrayScript(arrayScriptText(none), "f"), InputError);
}

TEST(SlurmScripts, OfAMergeAreKnownAsUneditedWhateverTheProgram) {
  const std::string text = mergeScriptText("blades", "/opt/fissure");
  EXPECT_TRUE(isUneditedMergeScript(text, "blades"));
  EXPECT_FALSE(isUneditedMergeScript(text + "#\n", "blades"));
  EXPECT_FALSE(isUneditedMergeScript("", "blades"));
}

TEST(SlurmScripts, WordsOfTheShell) {
  EXPECT_EQ(shellWord("/opt/a-b_1.2"), "/opt/a-b_1.2");
  EXPECT_EQ(shellWord("it's a $HOME"), "'it'\\''s a $HOME'");
  EXPECT_EQ(shellWord(""), "''");
}

TEST(SlurmScripts, RangesOfAnArray) {
  EXPECT_EQ(arrayRanges({}), "");
  EXPECT_EQ(arrayRanges({3}), "3");
  EXPECT_EQ(arrayRanges({1, 2, 4, 6, 7, 8}), "1-2,4,6-8");
  std::vector<std::size_t> odd;
  for (std::size_t i = 3; i < 20000; i += 2) odd.push_back(i);
  EXPECT_EQ(arrayRanges(odd), "3-19999") << "sbatch could not even be called with the others";
}

}  // namespace
}  // namespace fissure::slurm_scripts_test
