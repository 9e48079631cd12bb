// Everything in a result says what it is: units, named axes, what flags mean.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::walk_test {
namespace {

namespace fs = std::filesystem;

class Walk : public testing::Test {
 protected:
  void SetUp() override {
    python_ = pythonWith("h5py, numpy");
    if (python_.empty()) GTEST_SKIP() << "no python3 with h5py here";
  }
  /// Compares results, named after the book, with src/results/store/FORMAT.md.
  Outcome checkFormat(std::vector<std::string> words) const {
    words.insert(words.begin(), {python_, FISSURE_SOURCE_DIR "/tests/programs/check_format.py",
                                 FISSURE_SOURCE_DIR "/src/results/store/FORMAT.md"});
    return runTool(folder_, words);
  }
  Outcome walk(std::vector<std::string> files) const {
    files.insert(files.begin(), {python_, FISSURE_SOURCE_DIR "/tests/programs/walk_result.py"});
    return runTool(folder_, files);
  }

  Folder folder_;
  std::string python_;
};

TEST_F(Walk, NothingInAFullResultLacksUnitsOrAxes) {
  folder_.write("full.yaml",
                fullScenario("[{pipeline: default}, {pipeline: cluster, precision: f32}, {pipeline: "
                             "raycast}, {pipeline: prescribed}, {pipeline: fukuhara}]"));
  ASSERT_EQ(runFissure(folder_, {"run", "full.yaml", "-o", "full.h5"}).code, 0);
  folder_.write("bare.yaml", pressScenario());
  ASSERT_EQ(runFissure(folder_, {"run", "bare.yaml", "-o", "bare.h5"}).code, 0);
  folder_.write(
      "elastic.yaml",
      "format: 1\n"
      "name: elastic\n"
      "time: {step_s: 0.001}\n"
      "world: {gravity_m_s2: [0, 0, 0]}\n"
      "bodies:\n"
      "  - {name: block, model: elastic, shape: {type: box, size_m: [0.02, 0.02, 0.02], cells: [2, 2, 2]},\n"
      "     elastic: {viscosity_Pa_s: 5}, fixed: [{below_m: -0.009}]}\n"
      "tools:\n"
      "  - name: plate\n"
      "    shape: {type: box, size_m: [0.04, 0.002, 0.04]}\n"
      "    motion: {type: script, start_m: [0, 0.012, 0], segments: [{move_to_m: [0, 0.01, 0], "
      "speed_m_s: 0.2}]}\n"
      "pipelines: [{pipeline: swept}, {pipeline: prescribed}]\n"
      "record: {snapshots_every_s: 0.005}\n");
  ASSERT_EQ(runFissure(folder_, {"run", "elastic.yaml", "-o", "elastic.h5"}).code, 0);
  const Outcome outcome = walk({"full.h5", "bare.h5", "elastic.h5"});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

// Their scenarios have what the two above lack: replays, files, clamps of two kinds.
TEST_F(Walk, NothingInTheReferencesLacksUnitsOrAxes) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(FISSURE_SOURCE_DIR "/results/reference"))
    if (entry.path().extension() == ".h5") files.push_back(entry.path().string());
  ASSERT_GT(files.size(), 10U);
  const Outcome outcome = walk(files);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(Walk, EveryNameStandsInTheBookOfTheFormat) {
  folder_.write("full.yaml", fullScenario("[{pipeline: default}, {pipeline: fukuhara}]"));
  ASSERT_EQ(runFissure(folder_, {"run", "full.yaml", "-o", "full.h5"}).code, 0);
  folder_.write("elastic.yaml",
                "format: 1\n"
                "name: elastic\n"
                "time: {step_s: 0.001}\n"
                "world: {gravity_m_s2: [0, 0, 0]}\n"
                "bodies:\n"
                "  - name: block\n"
                "    model: elastic\n"
                "    shape: {type: box, size_m: [0.02, 0.02, 0.02], cells: [2, 2, 2]}\n"
                "    elastic:\n"
                "      viscosity_Pa_s: 5\n"
                "      regions: [{name: hard, box: {min_m: [-0.01, -0.01, -0.01], max_m: [0, 0.01, 0.01]},\n"
                "                 youngs_modulus_Pa: 20000}]\n"
                "    fixed: [{below_m: -0.009}]\n"
                "tools:\n"
                "  - name: plate\n"
                "    shape: {type: box, size_m: [0.04, 0.002, 0.04]}\n"
                "    coupling: {mass_kg: 0.05, stiffness_N_m: 3000, damping_N_s_m: 20, force: reaction}\n"
                "    force_limit_N: 8\n"
                "    motion: {type: script, start_m: [0, 0.012, 0],\n"
                "             segments: [{move_to_m: [0, 0.01, 0], speed_m_s: 0.2}]}\n"
                "pipelines: [{pipeline: swept}]\n"
                "record: {snapshots_every_s: 0.005}\n");
  ASSERT_EQ(runFissure(folder_, {"run", "elastic.yaml", "-o", "elastic.h5"}).code, 0);
  std::vector<std::string> words = {"--all", "full.h5", "elastic.h5"};
  for (const auto& entry : fs::directory_iterator(FISSURE_SOURCE_DIR "/results/reference"))
    if (entry.path().extension() == ".h5") words.push_back(entry.path().string());
  const Outcome outcome = checkFormat(words);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const std::vector<std::pair<std::string, std::string>> damages = {
      {"run['news'] = [1.0]", "news: no such dataset in the book"},
      {"run.attrs['news'] = 1", "fukuhara@news: no such attribute in the book"},
      {"run['summary'].attrs['news_m'] = 1.0", "summary@news_m: no such attribute in the book"},
      {"run['force'].attrs['units'] = 'm'", "force: the book says"}};
  for (const auto& [damage, complaint] : damages) {
    fs::copy_file(folder_ / "full.h5", folder_ / "damaged.h5", fs::copy_options::overwrite_existing);
    const Outcome edit = runTool(
        folder_,
        {python_, "-c",
         "import h5py; file = h5py.File('damaged.h5', 'r+'); run = file['pipelines/fukuhara']; " + damage});
    ASSERT_EQ(edit.code, 0) << edit.err;
    const Outcome found = checkFormat({"damaged.h5"});
    EXPECT_EQ(found.code, 1) << damage << found.err;
    EXPECT_NE(found.out.find(complaint), std::string::npos) << damage << "\n" << found.out;
  }
}

TEST_F(Walk, WhatIsLackingIsNamed) {
  folder_.write("s.yaml", fullScenario("[{pipeline: fukuhara}]"));
  ASSERT_EQ(runFissure(folder_, {"run", "s.yaml", "-o", "whole.h5"}).code, 0);
  const std::vector<std::pair<std::string, std::string>> damages = {
      {"del run['tool_force'].attrs['units']", "tool_force: units None"},
      {"run['force'].attrs['units'] = 'newton'", "force: units 'newton'"},
      {"run['force'].dims[1].detach_scale(run['time'])", "force: axis 1 has 0 scales"},
      {"run['tools/spatula/vertices'].dims[0].detach_scale(run['tools/spatula/vertex'])",
       "tools/spatula/vertices: axis 0 has 0 scales"},
      {"del run['node_state'].attrs['flag_meanings']", "node_state: a flag without"},
      {"run['node_state'][0, 0] = 9", "node_state: a value that is no flag"},
      {"run['time'][5] = 0", "time: rows do not increase"},
      {"del run['force'].attrs['hc_k_units']", "force: hc_k has no unit"},
      {"run['bare'] = [1.0, 2.0]", "bare: units None"},
      {"run['summary'].attrs['speed'] = 1.5", "summary/speed: neither a unit"},
      {"run['summary'].attrs['things'] = 3", "summary/things: neither a unit"}};
  for (const auto& [damage, complaint] : damages) {
    fs::copy_file(folder_ / "whole.h5", folder_ / "damaged.h5", fs::copy_options::overwrite_existing);
    const Outcome edit = runTool(
        folder_,
        {python_, "-c",
         "import h5py; file = h5py.File('damaged.h5', 'r+'); run = file['pipelines/fukuhara']; " + damage});
    ASSERT_EQ(edit.code, 0) << edit.err;
    const Outcome outcome = walk({"damaged.h5"});
    EXPECT_EQ(outcome.code, 1) << damage << outcome.err;
    EXPECT_NE(outcome.out.find(complaint), std::string::npos) << damage << "\n" << outcome.out;
  }
}

}  // namespace
}  // namespace fissure::programs::walk_test
