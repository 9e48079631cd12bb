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

/// The script with one of its lines written in another way.
std::string edited(const std::string& line, const std::string& by) {
  std::string text = arrayScriptText(script);
  const std::size_t at = text.find("\n" + line + "\n");
  return at == std::string::npos ? "test error: no " + line : text.replace(at + 1, line.size(), by);
}

bool isRefused(const std::string& text) {
  try {
    readArrayScript(text, "f");
  } catch (const InputError& error) {
    EXPECT_TRUE(error.isAbout("f"));
    return true;
  }
  return false;
}

const std::string about_line = "# Sweep blades: 24 simulations dealt to 4 shards.";
const std::string array_line = "#SBATCH --array=1-4%2";
const std::string cpus_line = "#SBATCH --cpus-per-task=2";
const std::string program_line = "program='/opt/my programs/fissure'";

TEST(SlurmScripts, LinesMayBeWrittenInAFewOtherWays) {
  EXPECT_EQ(readArrayScript(edited(about_line, about_line + " Keep it."), "f").sweep, "blades");
  EXPECT_EQ(
      readArrayScript(edited(about_line, "# Sweep a:b:: 24 simulations dealt to 4 shards.x"), "f").sweep,
      "a:b:");
  EXPECT_EQ(readArrayScript(edited(array_line, "#SBATCH --array=1-4 \t "), "f").throttle, "");
  EXPECT_EQ(readArrayScript(edited(array_line, "#SBATCH --array=1-04%010"), "f").throttle, "%010");
  EXPECT_EQ(readArrayScript(edited(cpus_line, cpus_line + "\t"), "f").cpus, 2U);
  EXPECT_EQ(readArrayScript(edited(cpus_line, "#SBATCH --cpus-per-task=1234567890"), "f").cpus, 999999999U);
  EXPECT_EQ(readArrayScript(edited(program_line, "program= other # \t"), "f").program, " other # \t");
  EXPECT_EQ(readArrayScript(edited(program_line, "program="), "f").program, "");
  EXPECT_EQ(readArrayScript(edited(cpus_line, cpus_line + "\n#SBATCH --cpus-per-task=3"), "f").cpus, 2U)
      << "the first one counts";
}

TEST(SlurmScripts, LinesThatAreAlmostRightAreNone) {
  for (const std::string about :
       {" # Sweep blades: 24 simulations dealt to 4 shards.", "# Sweep : 24 simulations dealt to 4 shards.",
        "# Sweep two words: 24 simulations dealt to 4 shards.",
        "# Sweep blades: 24 simulations dealt to 4 shards",
        "# Sweep blades:  24 simulations dealt to 4 shards.",
        "# Sweep blades: x simulations dealt to 4 shards.",
        "# Sweep blades: 24 simulations dealt to  shards.",
        "# Sweep blades 24 simulations dealt to 4 shards.",
        "# Sweep blades:\t24 simulations dealt to 4 shards.",
        "# Sweep blades: 24 simulations dealt to 4 shards.\r"})
    EXPECT_TRUE(isRefused(edited(about_line, about))) << about;
  for (const std::string array :
       {"#SBATCH --array=1-4%", "#SBATCH --array=1-", "#SBATCH --array=1-%2", "#SBATCH --array=1-4%2 # eight",
        "#SBATCH --array=0-4", "##SBATCH --array=1-4", "#SBATCH --array=1-4 %2", "#SBATCH --array=1-4\r",
        "#SBATCH --array=1-4%2%2"})
    EXPECT_TRUE(isRefused(edited(array_line, array))) << array;
  for (const std::string cpus :
       {"#SBATCH --cpus-per-task=", "#SBATCH --cpus-per-task=-2", "#SBATCH --cpus-per-task=2x",
        "#SBATCH --cpus-per-task= 2", "#SBATCH --cpus-per-task=2\r"})
    EXPECT_TRUE(isRefused(edited(cpus_line, cpus))) << cpus;
  for (const std::string program : {"export program=x", "program =x", "program=x\r"})
    EXPECT_TRUE(isRefused(edited(program_line, program))) << program;
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
