// A result is reproducible: by running again, and from the scenario it carries.
#include <gtest/gtest.h>

#include "program.h"
#include "scenarios.h"
#include "store/result_file.h"

namespace fissure::programs::repeat_test {
namespace {

const std::string all_pipelines =
    "[{pipeline: default}, {name: tuned, pipeline: default, settings: tuned}, {pipeline: raycast}, "
    "{pipeline: fukuhara}]";
const std::string record =
    "force: [{model: hunt_crossley}, {model: linear_elastic}]\n"
    "record: {snapshots_every_s: 0.005}\n";

std::vector<std::string> finalHashes(const std::filesystem::path& file) {
  std::vector<std::string> hashes;
  for (const PipelineResult& pipeline : readResultInfo(file).pipelines)
    for (const SummaryValue& value : pipeline.summary)
      if (value.name == "final_state_hash") hashes.push_back(std::get<std::string>(value.value));
  return hashes;
}

TEST(Repeat, SameScenarioTwiceGivesTheSameData) {
  const std::string python = pythonWith("h5py, numpy");
  if (python.empty()) GTEST_SKIP() << "no python3 with h5py here";
  const Folder folder;
  folder.write("s.yaml", pressScenario(all_pipelines, "0.05", record));
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "one.h5"}).code, 0);
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "two.h5", "-j", "2"}).code, 0);
  const std::string script = FISSURE_SOURCE_DIR "/scripts/result_bits.py";
  const Outcome same = runTool(folder, {python, script, "one.h5", "two.h5"});
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  // The script must be able to see a difference.
  ASSERT_EQ(
      runFissure(folder, {"run", "s.yaml", "-o", "three.h5", "--set", "bodies.sphere.mass_kg=0.1000001"})
          .code,
      0);
  EXPECT_EQ(runTool(folder, {python, script, "one.h5", "three.h5"}).code, 1);
}

TEST(Repeat, ResolvedScenarioOfAResultRunsAgainToTheSameState) {
  const Folder folder;
  folder.write("s.yaml", pressScenario(all_pipelines, "0.05", record));
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "one.h5", "--set", "bodies.sphere.mass_kg=0.12"}).code,
            0);
  folder.write("again.yaml", readResultInfo(folder / "one.h5").scenario_resolved);
  ASSERT_EQ(runFissure(folder, {"run", "again.yaml", "-o", "two.h5"}).code, 0);
  const std::vector<std::string> hashes = finalHashes(folder / "one.h5");
  ASSERT_EQ(hashes.size(), 4u);
  EXPECT_EQ(finalHashes(folder / "two.h5"), hashes);
  EXPECT_EQ(readResultInfo(folder / "two.h5").scenario_resolved,
            readResultInfo(folder / "one.h5").scenario_resolved);
}

}  // namespace
}  // namespace fissure::programs::repeat_test
