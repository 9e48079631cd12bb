// Sweeps that are killed, cut short, damaged or run twice: what comes out is what an undisturbed one gives,
// to the last bit, and nothing that was finished is computed again. scripts/sweep_kills.py does it fifty
// times.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "program.h"
#include "scenarios.h"
#include "sweeps.h"

namespace fissure::programs::sweep_fault_test {
namespace {

namespace fs = std::filesystem;

/// Twelve simulations with four sets of laws each, a twentieth of a second each.
const std::string small =
    "axes:\n"
    "  - {path: bodies.sphere.mass_kg, values: [0.1, 0.11, 0.12]}\n"
    "  - {path: tools.spatula.motion.segments.0.speed_m_s, values: [0.5, 0.4]}\n"
    "  - {path: force.hc.k, values: [100, 200, 300, 400]}\n";

class Disturbed : public testing::Test {
 protected:
  Disturbed() {
    folder_.write("press.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.03", laws));
    folder_.write("s.yaml", sweepOf(small + curves));
    python_ = pythonWith("h5py, numpy");
  }

  /// The same sweep without any harm, in the folder "truth".
  void makeTruth() {
    const Outcome outcome = runFissure(folder_, {"sweep", "s.yaml", "-o", "truth", "-j", "2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }

  void expectTruth(const std::string& name) {
    EXPECT_EQ(folder_.read(name + "/sweep.csv"), folder_.read("truth/sweep.csv"));
    if (python_.empty()) return;
    const Outcome same = runTool(folder_, {python_, FISSURE_SOURCE_DIR "/scripts/result_bits.py",
                                           "truth/sweep.h5", name + "/sweep.h5"});
    EXPECT_EQ(same.code, 0) << same.out << same.err;
  }

  std::vector<fs::path> journals(const std::string& name) const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_ / name / "journals"))
      files.push_back(entry.path());
    return files;
  }

  Folder folder_;
  std::string python_;
};

/// "to do: 3 of 12 simulations": 3.
int toDo(const Outcome& outcome) {
  const std::string start = "to do: ";
  const std::size_t at = outcome.out.find(start);
  if (at == std::string::npos) return -1;
  const std::string rest = outcome.out.substr(at + start.size());
  const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  return digits > 0 && rest.substr(digits).starts_with(" of") ? std::stoi(rest.substr(0, digits)) : -1;
}

TEST_F(Disturbed, KilledAtAnyMomentItGoesOn) {
  makeTruth();
  std::mt19937 random(3);
  for (int trial = 0; trial < 4; ++trial) {
    const std::string name = "out" + std::to_string(trial);
    {
      Program sweep(folder_, {fissureProgram(), "sweep", "s.yaml", "-o", name, "-j", "2"});
      const pid_t worker = sweep.waitForWorker();
      ASSERT_GT(worker, 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 300));
      if (trial % 2 == 0) ::kill(worker, SIGKILL);
      if (trial != 0) sweep.send(SIGKILL);
      sweep.wait();
      EXPECT_TRUE(endsSoon(worker));
    }
    const Outcome again = runFissure(folder_, {"sweep", name, "-j", "2"});
    EXPECT_EQ(again.code, 0) << again.err;
    expectTruth(name);
    for (const fs::path& left : journals(name)) EXPECT_EQ(left.extension(), ".journal") << left;
  }
}

TEST_F(Disturbed, ShardsInAnyOrderAndTwiceGiveTheSame) {
  makeTruth();
  for (const char* shard : {"3/3", "1/3", "3/3", "2/3"})
    ASSERT_EQ(runFissure(folder_, {"sweep", "s.yaml", "-o", "out", "--shard", shard}).code, 0);
  const Outcome merged = runFissure(folder_, {"sweep", "merge", "out"});
  EXPECT_EQ(merged.code, 0) << merged.err;
  expectTruth("out");
}

TEST_F(Disturbed, ASweepThatRunsTwiceAtOnceIsStillRight) {
  makeTruth();
  Program one(folder_, {fissureProgram(), "sweep", "s.yaml", "-o", "out"});
  Program two(folder_, {fissureProgram(), "sweep", "s.yaml", "-o", "out"});
  for (Program* program : {&one, &two}) {
    const Outcome outcome = program->wait();
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  }
  expectTruth("out");
}

TEST_F(Disturbed, AnUnfinishedMergeSaysWhatIsMissing) {
  ASSERT_EQ(runFissure(folder_, {"sweep", "s.yaml", "-o", "out", "--shard", "1/3"}).code, 0);
  const Outcome merged = runFissure(folder_, {"sweep", "merge", "out"});
  EXPECT_EQ(merged.code, 3);
  EXPECT_NE(merged.out.find("48 runs: 32 missing, 16 ok"), std::string::npos) << merged.out;
}

TEST_F(Disturbed, InterruptedItSaysSoAndGoesOn) {
  makeTruth();
  {
    Program sweep(folder_, {fissureProgram(), "sweep", "s.yaml", "-o", "out"});
    ASSERT_GT(sweep.waitForWorker(), 0);
    sweep.send(SIGINT);
    const Outcome outcome = sweep.wait();
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("`fissure sweep out` goes on"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(runFissure(folder_, {"sweep", "out"}).code, 0);
  expectTruth("out");
}

TEST_F(Disturbed, WhatIsDamagedInAJournalIsMadeAgain) {
  makeTruth();
  ASSERT_EQ(runFissure(folder_, {"sweep", "s.yaml", "-o", "out"}).code, 0);
  const fs::path journal = journals("out").at(0);
  {
    std::fstream file(journal, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(journal) * 2 / 3));
    file << "damage";
  }
  const Outcome again = runFissure(folder_, {"sweep", "out"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_GT(toDo(again), 0);
  EXPECT_LT(toDo(again), 12);
  EXPECT_NE(again.out.find("its end is torn or damaged"), std::string::npos) << again.out;
  expectTruth("out");
}

TEST_F(Disturbed, AResultDamagedByHandIsMadeAgainAndNoOther) {
  folder_.write("s.yaml", sweepOf(small + "keep: results\n"));
  makeTruth();
  fs::path result;
  for (const auto& entry : fs::directory_iterator(folder_ / "truth/runs")) result = entry.path();
  const std::string whole = folder_.read("truth/runs/" + result.filename().string());
  fs::resize_file(result, whole.size() / 2);
  const Outcome again = runFissure(folder_, {"sweep", "truth"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(toDo(again), 1);
  EXPECT_TRUE(readResultInfo(result).complete);
  fs::remove(result);
  EXPECT_EQ(toDo(runFissure(folder_, {"sweep", "truth"})), 1);
  fs::last_write_time(result, fs::file_time_type::clock::now());  // touched, but whole
  EXPECT_EQ(toDo(runFissure(folder_, {"sweep", "truth"})), 0);
}

// In a copy without times all results would be opened, by each shard and for each status.
TEST_F(Disturbed, ResultsAreOpenedOnlyByWhomTheyConcern) {
  folder_.write("s.yaml", sweepOf("pipelines: [default]\nkeep: results\n"
                                  "axes: [{path: bodies.sphere.mass_kg, values: [0.1, 0.11]}]\n"));
  ASSERT_EQ(runFissure(folder_, {"sweep", "s.yaml", "-o", "out", "--shard", "2/2"}).code, 0);
  for (const auto& entry : fs::directory_iterator(folder_ / "out/runs")) {
    const auto bytes = fs::file_size(entry.path());
    fs::resize_file(entry.path(), 0);
    fs::resize_file(entry.path(), bytes);
  }
  const Outcome status = runFissure(folder_, {"sweep", "status", "out"});
  EXPECT_EQ(toDo(status), 1) << "its size is as it was: " << status.out;
  const Outcome first = runFissure(folder_, {"sweep", "out", "--shard", "1/2"});
  EXPECT_EQ(toDo(first), 1);
  EXPECT_NE(first.out.find(" ms each)"), std::string::npos) << "as long as the one of the other shard took";
  EXPECT_EQ(toDo(runFissure(folder_, {"sweep", "out", "--shard", "2/2"})), 1);
}

TEST_F(Disturbed, OnlyWhatChangedIsRunAgain) {
  makeTruth();
  EXPECT_EQ(toDo(runFissure(folder_, {"sweep", "s.yaml", "-o", "truth"})), 0);
  folder_.write("s.yaml", sweepOf(with(small, "[0.1, 0.11, 0.12]", "[0.12, 0.13, 0.1]") + curves));
  const Outcome other = runFissure(folder_, {"sweep", "s.yaml", "-o", "truth"});
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_EQ(toDo(other), 4);  // of one new mass
  EXPECT_NE(other.out.find("4 records of an earlier form of the sweep"), std::string::npos) << other.out;
  folder_.write("press.yaml", with(folder_.read("press.yaml"), "step_s: 0.001", "step_s: 0.0005"));
  EXPECT_EQ(toDo(runFissure(folder_, {"sweep", "s.yaml", "-o", "truth"})), 12);
}

TEST_F(Disturbed, TwoRecordsOfOneTaskThatDifferAreRefused) {
  makeTruth();
  ASSERT_EQ(runFissure(folder_, {"sweep", "s.yaml", "-o", "out"}).code, 0);
  // The same tasks with other numbers: a worker that is not deterministic would leave such records.
  folder_.write(
      "forge.py",
      "import glob, hashlib, sys\n"
      "def fnv(data):\n"
      "    value = 0xcbf29ce484222325\n"
      "    for byte in data:\n"
      "        value = ((value ^ byte) * 0x100000001b3) & 0xffffffffffffffff\n"
      "    return b'%016x' % value\n"
      "data = open(glob.glob('out/journals/*.journal')[0], 'rb').read()\n"
      "length = int(data[4:20], 16)\n"
      "record = bytearray(data[36:36 + length])\n"
      "at = record.index(b'fcurves') + 40 if b'fcurves' in record else record.index(b'curves') + 40\n"
      "record[at] ^= 1\n"
      "open('out/journals/forged.journal', 'wb').write(data[:20] + fnv(record) + record)\n");
  ASSERT_EQ(runTool(folder_, {"/usr/bin/python3", "forge.py"}).code, 0);
  const Outcome merged = runFissure(folder_, {"sweep", "merge", "out"});
  EXPECT_EQ(merged.code, 3);
  EXPECT_TRUE(isOneLine(merged.err)) << merged.err;
  EXPECT_NE(merged.err.find("gave different numbers"), std::string::npos) << merged.err;
}

TEST_F(Disturbed, AFullDiskIsOneLineAndLosesNothing) {
  makeTruth();
  Program::Limits limits;
  limits.file_bytes = 60000;
  Program sweep(folder_, {fissureProgram(), "sweep", "s.yaml", "-o", "out"}, limits);
  const Outcome outcome = sweep.wait();
  EXPECT_EQ(outcome.code, 3) << outcome.out;
  EXPECT_NE(outcome.err.find("cannot write"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "out/sweep.h5"));
  const Outcome again = runFissure(folder_, {"sweep", "out"});
  EXPECT_EQ(again.code, 0) << again.err;
  expectTruth("out");
}

TEST_F(Disturbed, AnotherWorkerProgramIsAnotherPlan) {
  makeTruth();
  for (const char* name : {"fissure-engine-f64", "fissure-engine-f32"})
    fs::copy(fs::path(fissureProgram()).parent_path() / name, folder_ / name);
  std::ofstream(folder_ / "fissure-engine-f64", std::ios::app) << "another build";
  const auto with_engine = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"env", "FISSURE_ENGINE_DIR=" + folder_.path().string(), fissureProgram()};
    all.insert(all.end(), words.begin(), words.end());
    return runTool(folder_, all);
  };
  const Outcome refused = with_engine({"sweep", "truth"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("was planned with another fissure-engine-f64"), std::string::npos)
      << refused.err;
  EXPECT_EQ(toDo(with_engine({"sweep", "s.yaml", "-o", "truth"})), 12);
}

TEST_F(Disturbed, ProgressIsOneLineOnATerminal) {
  folder_.write("s.yaml",
                sweepOf("axes: [{path: bodies.sphere.mass_kg, values: [0.1, 0.11]}]\nlimits: {time_s: 1}\n"));
  folder_.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "10000"));
  Program sweep(folder_, {fissureProgram(), "sweep", "s.yaml", "-o", "out"},
                {.file_bytes = {}, .error_is_terminal = true});
  const Outcome outcome = sweep.wait();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("\r\x1b[K0/2 simulations, "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("/2 simulations, 1 failed"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(" left"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("\r\x1b[Kfirst failure: "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
}

}  // namespace
}  // namespace fissure::programs::sweep_fault_test
