// Sweeps submitted to Slurm, whose programs are played by scripts: what they are told, and what is written.
// A real Slurm: tests/programs/cluster.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::slurm_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* blades =
    "format: 1\n"
    "name: blades\n"
    "base: press.yaml\n"
    "axes:\n"
    "  - {path: bodies.sphere.mass_kg, values: [0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.11, 0.12]}\n";

/// Answers of sbatch are job 101, 102, ..., and what is in `cluster`; what it was told stands in `calls`, a
/// line each.
class SlurmTest : public testing::Test {
 protected:
  SlurmTest() {
    fs::create_directories(folder_ / "bin");
    tool("scontrol",
         "if [ \"$1\" = show ]; then cat \"$at/config\"; else echo \"$*\" >> \"$at/requeued\"; fi");
    tool("squeue", "cat \"$at/queue\"");
    tool("sbatch",
         "if [ $(wc -l < \"$at/calls\") -ge $(cat \"$at/most\") ]; then echo 'sbatch: error: Invalid "
         "account' >&2; "
         "exit 1; fi; "
         "for word; do printf '[%s]' \"$word\"; done >> \"$at/calls\"; echo >> \"$at/calls\"; "
         "echo $((100 + $(wc -l < \"$at/calls\")))\"$(cat \"$at/cluster\")\"");
    limits("1001", "10000");
    for (const char* name : {"queue", "calls", "cluster", "requeued"}) folder_.write(name, "");
    folder_.write("most", "99");
    folder_.write("press.yaml", pressScenario());
    folder_.write("blades.yaml", blades);
  }

  void tool(const std::string& name, const std::string& script) const {
    folder_.write("bin/" + name, "#!/bin/sh\nat=$(dirname \"$0\")/..\n" + script + "\n");
    fs::permissions(folder_ / ("bin/" + name), fs::perms::owner_all);
  }
  void limits(const std::string& array_size, const std::string& jobs) const {
    folder_.write("config", "ClusterName = x\nMaxArraySize            = " + array_size +
                                "\nMaxJobCount             = " + jobs + "\n");
  }
  std::string path() const { return "PATH=" + (folder_ / "bin").string() + ":/usr/bin:/bin"; }
  Outcome sweep(std::vector<std::string> words) const {
    words.insert(words.begin(), {"env", path(), fissureProgram(), "sweep"});
    return runTool(folder_, words);
  }
  /// Plans the sweep into "d" and submits it in four shards.
  Outcome first(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"blades.yaml", "-o", "d", "--engine", "slurm", "--shards", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return sweep(words);
  }
  Outcome again(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"d", "--engine", "slurm"};
    words.insert(words.end(), more.begin(), more.end());
    return sweep(words);
  }
  std::string calls() const {
    std::string text = folder_.read("calls");
    folder_.write("calls", "");
    return text;
  }
  /// What sbatch is told of this script.
  std::string chdirAnd(const std::string& script) const {
    const std::string folder = (folder_ / "d").string();
    return "[--chdir=" + folder + "][" + folder + "/slurm/" + script + ".sbatch]\n";
  }

  Folder folder_;
};

bool says(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST_F(SlurmTest, IsNamedWhereItIsMissing) {
  fs::remove(folder_ / "bin/sbatch");
  const Outcome outcome = runTool(folder_, {"env", "PATH=" + (folder_ / "bin").string(), fissureProgram(),
                                            "sweep", "blades.yaml", "-o", "d", "--engine", "slurm"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_TRUE(says(outcome.err, "sbatch")) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "d"));
}

TEST_F(SlurmTest, GetsAnArrayAndThenTheMerge) {
  const Outcome outcome = first({"--", "--partition=my part", "-A", "x"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(calls(), "[--parsable][--partition=my part][-A][x][--array=1-4]" + chdirAnd("array") +
                         "[--parsable][--partition=my part][-A][x][--dependency=afterany:101]" +
                         chdirAnd("merge"));
  EXPECT_EQ(folder_.read("d/slurm/jobs"), "101 array\n102 merge\n");
  EXPECT_TRUE(fs::is_directory(folder_ / "d/slurm/logs"));
}

TEST_F(SlurmTest, IsAskedOnlyForShardsThatMissSomething) {
  ASSERT_EQ(first({"-j", "2"}).code, 0);
  calls();
  ASSERT_EQ(sweep({"d", "--shard", "1/4"}).code, 0);
  ASSERT_EQ(sweep({"d", "--shard", "3/4"}).code, 0);
  EXPECT_EQ(again({"--json"}).out,
            "{\n  \"exit_code\": 0,\n  \"shards\": 4,\n  \"missing\": \"2,4\",\n"
            "  \"array_job\": \"101\",\n  \"merge_job\": \"102\"\n}\n");
  EXPECT_TRUE(says(calls(), "[--array=2,4]"));
  EXPECT_TRUE(says(folder_.read("d/slurm/array.sbatch"), "--cpus-per-task=2\n")) << "as it was";
  ASSERT_EQ(sweep({"d"}).code, 0);
  EXPECT_EQ(again().code, 0);
  EXPECT_EQ(calls(), "[--parsable]" + chdirAnd("merge")) << "nothing is missing";
}

TEST_F(SlurmTest, IsNotToldTwiceUnawares) {
  ASSERT_EQ(first().code, 0);
  folder_.write("queue", "55 RUNNING\n101 RUNNING\n101 PENDING\n101 PENDING\n102 PENDING\n");
  calls();
  const Outcome refused = again();
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(isOneLine(refused.err));
  EXPECT_TRUE(says(refused.err, "101 (array): 2 pending, 1 running; 102 (merge): 1 pending")) << refused.err;
  EXPECT_EQ(first().code, 2);
  EXPECT_EQ(again({"--dry-run"}).code, 0);
  EXPECT_EQ(calls(), "");
  EXPECT_TRUE(says(sweep({"status", "d"}).out, "slurm: 101 (array): 2 pending"));
  EXPECT_EQ(again({"--again"}).code, 0);
  EXPECT_TRUE(says(calls(), "[--dependency=afterany:101:101]")) << "of the first and of this array";
}

TEST_F(SlurmTest, LimitsTheNumberOfShards) {
  limits("4", "10000");
  const Outcome refused = first();
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(says(refused.err, "takes 3 in an array (MaxArraySize 4,")) << refused.err;
  folder_.write("blades.yaml", with(blades, "values: [0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.11, 0.12]",
                                    "linear: {from: 0.05, to: 0.1, count: 2000}"));
  const std::vector<std::string> by_time = {"blades.yaml",     "-o",  "d", "--engine", "slurm",
                                            "--shard-minutes", "0.01"};
  EXPECT_EQ(sweep(by_time).code, 0);
  EXPECT_TRUE(says(calls(), "[--array=1-3]"));
  tool("sacctmgr", "echo '3|'");
  EXPECT_TRUE(says(sweep(by_time).out, "you may have 2 beside the merge (MaxSubmitJobs)"));
  EXPECT_TRUE(says(calls(), "[--array=1-2]"));
  folder_.write("blades.yaml", blades);
  limits("1", "10000");
  EXPECT_TRUE(says(first().err, "this cluster takes no arrays (MaxArraySize 1)"));
  limits("1001", "3");
  EXPECT_TRUE(says(first().err, "takes 2 in an array"));
  limits("1001", "10000");
  EXPECT_EQ(first().code, 0);
  limits("3", "10000");
  EXPECT_EQ(again().code, 0) << "as many as before are too many now, and nobody asked for them";
  EXPECT_TRUE(says(folder_.read("d/slurm/array.sbatch"), "\nshards=1\n"));
}

// 100,000 simulations of a millisecond or so: far more shards would be of use than an array takes.
TEST_F(SlurmTest, PlansAHundredThousandSimulationsInSecondsAndAFewFiles) {
  folder_.write(
      "blades.yaml",
      "format: 1\nname: blades\nbase: press.yaml\naxes:\n"
      "  - {path: bodies.sphere.mass_kg, linear: {from: 0.05, to: 0.2, count: 1000}}\n"
      "  - {path: tools.spatula.motion.segments.0.speed_m_s, linear: {from: 0.1, to: 1, count: 100}}\n");
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = sweep({"blades.yaml", "-o", "d", "--engine", "slurm", "--shard-minutes", "0.01"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(says(outcome.out, "100000 runs in 100000 simulations")) << outcome.out;
  EXPECT_TRUE(says(outcome.out, "shards would be right, this cluster takes 1000 in")) << outcome.out;
  EXPECT_TRUE(says(calls(), "[--array=1-1000]"));
  const Outcome resumed = sweep({"d", "--shard", "1/100000"});
  EXPECT_TRUE(says(resumed.out, "to do: 1 of 100000 simulations")) << resumed.out << resumed.err;
  const Outcome status = sweep({"status", "d"});
  EXPECT_TRUE(says(status.out, "99999 missing, 1 ok")) << status.out;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  const auto files = std::distance(fs::recursive_directory_iterator(folder_ / "d"), {});
  EXPECT_LT(files, 10) << "what a resumption opens: the plan, a journal a session, the sbatch files";
}

TEST_F(SlurmTest, ScriptsAreKeptAsTheyWereEdited) {
  ASSERT_EQ(first().code, 0);
  const std::string array = folder_.read("d/slurm/array.sbatch");
  folder_.write("d/slurm/array.sbatch",
                with(with(array, "##SBATCH --partition=NAME", "#SBATCH --partition=p"), "--array=1-4",
                     "--array=1-4%2"));
  folder_.write("d/slurm/merge.sbatch", folder_.read("d/slurm/merge.sbatch") + "echo merged\n");
  const std::string edited = folder_.read("d/slurm/array.sbatch");
  calls();
  const Outcome same = again();
  EXPECT_TRUE(says(same.out, "array.sbatch: was edited, and is kept\n")) << same.out;
  EXPECT_TRUE(says(same.out, "merge.sbatch: was edited, and is kept\n")) << same.out;
  EXPECT_EQ(folder_.read("d/slurm/array.sbatch"), edited);
  EXPECT_TRUE(says(calls(), "[--array=1-4%2]"));
  folder_.write("d/slurm/array.sbatch", with(edited, "--array=1-4%2", "--array=1-9%2"));
  EXPECT_TRUE(says(again().err, "--array=1-9 with shards=4, expected the same number"));
  folder_.write("d/slurm/array.sbatch", edited);
  const Outcome other = again({"--shards", "3", "-j", "5"});
  EXPECT_TRUE(says(other.out, "but for its number of shards, now 3")) << other.out;
  const std::string changed = folder_.read("d/slurm/array.sbatch");
  EXPECT_TRUE(says(changed, "--partition=p\n") && says(changed, "=1-3%2\n") && says(changed, "shards=3\n"));
  EXPECT_TRUE(says(calls(), "[--cpus-per-task=5][--array=1-3%2]"));
  folder_.write("d/slurm/array.sbatch", with(changed, "shards=3", "shards=all"));
  EXPECT_EQ(again().code, 2);
  fs::remove(folder_ / "d/slurm/array.sbatch");
  EXPECT_EQ(again().code, 0);
}

TEST_F(SlurmTest, RefusesInOneLine) {
  folder_.write("most", "0");
  Outcome outcome = first();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "sbatch: error: Invalid account\n");
  EXPECT_FALSE(fs::exists(folder_ / "d/slurm/jobs"));
  folder_.write("most", "1");
  outcome = first();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(isOneLine(outcome.err) && says(outcome.err, "the shards are queued, job 101")) << outcome.err;
  EXPECT_EQ(folder_.read("d/slurm/jobs"), "101 array\n");
  EXPECT_TRUE(says(outcome.err, "when they have ended: fissure sweep merge d\n")) << outcome.err;
  calls();
  outcome = again({"--json"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out,
            "{\n  \"exit_code\": 3,\n  \"shards\": 4,\n  \"missing\": \"1-4\",\n"
            "  \"array_job\": \"101\",\n  \"merge_job\": \"\"\n}\n");
  tool("squeue", "echo 'squeue: error: no controller' >&2; exit 1");
  EXPECT_EQ(again().code, 3);
  EXPECT_EQ(again({"--dry-run"}).code, 0) << "submits nothing: nobody needs to know what is queued";
  EXPECT_EQ(again({"--no-submit"}).code, 0);
  tool("scontrol", "echo 'scontrol: error: no controller' >&2; exit 1");
  outcome = again();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "scontrol: error: no controller\n");
}

TEST_F(SlurmTest, OptionsThatDoNotFit) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--", "--array=1-9"},
                                             {"--", "-a", "1"},
                                             {"--", "-a1-5"},
                                             {"--", "--wait"},
                                             {"--", "-p", "all", "blades.yaml"},
                                             {"--", "--exclusive", "blades.yaml"},
                                             {"word"},
                                             {"--shard", "1/2"},
                                             {"--fail-fast"},
                                             {"--engine", "local", "--", "-p", "x"}}) {
    const Outcome outcome = first(words);
    EXPECT_EQ(outcome.code, 2) << words.front();
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  }
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--shards", "2"},
                                                                                     {"--shard-minutes", "2"},
                                                                                     {"--no-submit"},
                                                                                     {"--again"},
                                                                                     {"word"},
                                                                                     {"--", "-x"}}) {
    std::vector<std::string> all = {"blades.yaml", "-o", "d"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(sweep(all).code, 2) << words.front();
  }
  EXPECT_FALSE(fs::exists(folder_ / "d"));
}

TEST_F(SlurmTest, OfSeveralClustersSaysWhich) {
  folder_.write("cluster", ";alpha");
  ASSERT_EQ(first().code, 0);
  EXPECT_TRUE(says(calls(), "[--dependency=afterany:101]"));
  EXPECT_EQ(folder_.read("d/slurm/jobs"), "101 array\n102 merge\n");
}

TEST_F(SlurmTest, WritesTheMergesLogApart) {
  ASSERT_EQ(first({"--", "--output=logs_%A_%a"}).code, 0);
  const std::string told = calls();
  EXPECT_TRUE(says(told, "[--output=logs_%A_%a][--array=1-4]")) << told;
  EXPECT_TRUE(says(told, "[--output=logs_%A_%a][--output=slurm/logs/merge_%j.log]")) << told;
}

TEST_F(SlurmTest, MayBeToldByHand) {
  folder_.write("cluster", ";alpha");
  const Outcome outcome = first({"--no-submit", "--", "--comment=it's"});
  ASSERT_EQ(outcome.code, 0);
  EXPECT_EQ(calls(), "");
  const std::string commands = outcome.out.substr(outcome.out.find("  cd "));
  ASSERT_EQ(runTool(folder_, {"env", path(), "sh", "-ec", commands}).code, 0) << commands;
  EXPECT_EQ(calls(),
            "[--parsable][--comment=it's][--array=1-4][slurm/array.sbatch]\n"
            "[--comment=it's][--dependency=afterany:101][slurm/merge.sbatch]\n");
}

/// What Slurm does with a script, as task 1 of array 7.
class SlurmScriptTest : public SlurmTest {
 protected:
  std::vector<std::string> words(const std::string& script) const {
    return {"env",
            path(),
            "SLURM_ARRAY_TASK_ID=1",
            "SLURM_ARRAY_JOB_ID=7",
            "bash",
            "-c",
            "cd d && exec bash slurm/" + script + ".sbatch"};
  }
  /// Plans one shard of simulations of so many seconds, and runs it until `stop`; then its time is up.
  template <typename Stop>
  int codeOfLateTask(const std::string& durations, const Stop& stop) {
    folder_.write("blades.yaml", with(with(blades, "bodies.sphere.mass_kg", "time.duration_s"),
                                      "0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.11, 0.12", durations));
    EXPECT_EQ(sweep({"blades.yaml", "-o", "d", "--engine", "slurm", "--shards", "1", "--no-submit"}).code, 0);
    return codeOfNextTask(stop);
  }
  /// The same once more.
  template <typename Stop>
  int codeOfNextTask(const Stop& stop) {
    Program task(folder_, words("array"));
    while (!stop()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    task.send(SIGUSR1);
    return task.wait().code;
  }
  /// Bytes in journals; -1: there is none.
  long journalBytes() const {
    long bytes = -1;
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator(folder_ / "d/journals", gone))
      if (entry.path().extension() == ".journal")
        bytes = std::max(bytes, 0L) + static_cast<long>(entry.file_size());
    return bytes;
  }
};

TEST_F(SlurmScriptTest, RunsAShardAndMergesTheRest) {
  ASSERT_EQ(first({"--no-submit"}).code, 0);
  EXPECT_EQ(runTool(folder_, words("array")).code, 0);
  const Outcome merged = runTool(folder_, words("merge"));
  EXPECT_EQ(merged.code, 3) << "runs are missing";
  EXPECT_TRUE(says(merged.out, "6 missing, 2 ok")) << merged.out;
  EXPECT_EQ(folder_.read("requeued"), "");
}

TEST_F(SlurmScriptTest, RunsItsShardWithoutTemporaryFiles) {
  ASSERT_EQ(first({"--no-submit"}).code, 0);
  std::vector<std::string> without = words("array");
  without.insert(without.begin() + 1, "TMPDIR=" + (folder_ / "none").string());
  EXPECT_EQ(runTool(folder_, without).code, 0);
  EXPECT_TRUE(fs::is_empty(folder_ / "d/slurm/logs"));
  fs::remove_all(folder_ / "d/slurm/logs");
  EXPECT_EQ(runTool(folder_, without).code, 0);
}

TEST_F(SlurmScriptTest, QueuesAgainWhenItsTimeIsUpAndItGotSomethingDone) {
  EXPECT_EQ(codeOfLateTask("0.03, 10000", [&] { return journalBytes() > 0; }), 130);
  EXPECT_EQ(folder_.read("requeued"), "requeue 7_1\n");
}

TEST_F(SlurmScriptTest, QueuesAgainForWhatItTriedForTheFirstTimeAlone) {
  const std::string limited = "1000, 10000]}\nlimits: {time_s: 1}\n#";
  EXPECT_EQ(codeOfLateTask(limited, [&] { return journalBytes() > 0; }), 130);
  EXPECT_EQ(folder_.read("requeued"), "requeue 7_1\n") << "one has failed, the other was not tried";
  const long tried_once = journalBytes();
  EXPECT_EQ(codeOfNextTask([&] { return journalBytes() > tried_once; }), 130);
  EXPECT_EQ(folder_.read("requeued"), "requeue 7_1\nrequeue 7_1\n");
  const long tried = journalBytes();
  EXPECT_EQ(codeOfNextTask([&] { return journalBytes() > tried; }), 130);
  EXPECT_EQ(folder_.read("requeued"), "requeue 7_1\nrequeue 7_1\n") << "it would go on for ever";
}

TEST_F(SlurmScriptTest, DoesNotQueueAgainForNothing) {
  EXPECT_EQ(codeOfLateTask("10000, 20000", [&] { return journalBytes() == 0; }), 130);
  EXPECT_EQ(folder_.read("requeued"), "");
}

}  // namespace
}  // namespace fissure::programs::slurm_test
