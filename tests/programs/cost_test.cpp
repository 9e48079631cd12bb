// What a scenario does not ask for is not there: no library, no dataset, no stage.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "program.h"
#include "scenarios.h"
#include "store/result_file.h"

namespace fissure::programs::cost_test {
namespace {

/// Everything mapped into the worker of an endless run, once it is past its start.
std::string mapsDuring(const std::string& scenario, const std::vector<std::string>& options) {
  const Folder folder;
  folder.write("s.yaml", scenario);
  std::vector<std::string> words = {fissureProgram(), "run", "s.yaml", "-o", "out.h5"};
  words.insert(words.end(), options.begin(), options.end());
  Program run(folder, words, {.file_bytes = {}, .error_is_terminal = false});
  const pid_t worker = run.waitForWorker();
  if (worker == 0) return "";
  std::string maps;
  for (int i = 0; i < 400 && maps.find("OSMesa") == std::string::npos;
       ++i) {  // two seconds, or until it is there
    std::ifstream file("/proc/" + std::to_string(worker) + "/maps");
    maps.assign(std::istreambuf_iterator<char>(file), {});
    usleep(5000);
  }
  return maps;
}

const std::string frames = "record: {frames: {every_s: 1000, size_px: [64, 48]}}\n";

TEST(Cost, RendererIsLoadedOnlyForFrames) {
  const std::string without = mapsDuring(endlessScenario(), {});
  EXPECT_NE(without.find("libBullet"), std::string::npos) << "this is the worker, past its start";
  EXPECT_EQ(without.find("OSMesa"), std::string::npos);
  EXPECT_EQ(mapsDuring(endlessScenario("[{pipeline: fukuhara}]", frames), {"--no-frames"}).find("OSMesa"),
            std::string::npos);
  EXPECT_NE(mapsDuring(endlessScenario("[{pipeline: fukuhara}]", frames), {}).find("OSMesa"),
            std::string::npos)
      << "the comparison above would find it";
}

TEST(Cost, FrontLinksNoBulletAndNoRenderer) {
  const Folder folder;
  const Outcome outcome = runTool(folder, {"ldd", fissureProgram()});
  ASSERT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.find("Bullet"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("OSMesa"), std::string::npos) << outcome.out;
  const Outcome worker = runTool(folder, {"ldd", engineWorkerProgram()});
  EXPECT_NE(worker.out.find("Bullet"), std::string::npos) << "the comparison above would find it";
  EXPECT_EQ(worker.out.find("OSMesa"), std::string::npos) << worker.out;
}

std::vector<std::string> datasetsOf(const std::string& scenario) {
  const Folder folder;
  folder.write("s.yaml", scenario);
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  std::vector<std::string> paths;
  for (const DatasetInfo& dataset : readResultInfo(folder / "out.h5").datasets) paths.push_back(dataset.path);
  return paths;
}

bool hasAny(const std::vector<std::string>& paths, const std::string& ending) {
  return std::any_of(paths.begin(), paths.end(),
                     [&](const std::string& path) { return path.ends_with(ending); });
}

TEST(Cost, UnaskedDatasetsAreAbsent) {
  const std::vector<std::string> bare = datasetsOf(pressScenario());
  for (const char* name : {"/positions", "/snapshot_time", "/node_state", "/vertex_contact", "/frames",
                           "/frame_time", "/force", "/law", "/force_elastic", "/adhesion_clamped",
                           "/tool_force", "/saturated", "/deformation_max", "/colliding_triangles"})
    EXPECT_FALSE(hasAny(bare, name)) << name;
  EXPECT_TRUE(hasAny(bare, "/penetration_depth"));
  const std::vector<std::string> all = datasetsOf(
      pressScenario("[{pipeline: fukuhara}]", "0.03",
                    "force: [{model: linear_elastic}]\n"
                    "record: {snapshots_every_s: 0.01, frames: {every_s: 0.01, size_px: [64, 48]}}\n"));
  for (const char* name : {"/positions", "/snapshot_time", "/node_state", "/vertex_contact", "/frames",
                           "/frame_time", "/force", "/law"})
    EXPECT_TRUE(hasAny(all, name)) << name;
}

// `plan` knows which pipelines put nodes on tools without asking the engine.
TEST(Cost, PlanAndRunAgreeOnToolNodes) {
  for (const std::string pipeline : {"default", "\"null\"", "cluster", "raycast", "fukuhara"}) {
    const Folder folder;
    folder.write("s.yaml", pressScenario("[{pipeline: " + pipeline + "}]", "0.005"));
    const Outcome plan = runFissure(folder, {"plan", "s.yaml"});
    EXPECT_EQ(plan.code, 0) << plan.err;
    const bool planned = plan.out.find("32 tool nodes") != std::string::npos;
    EXPECT_EQ(planned, hasAny(datasetsOf(folder.read("s.yaml")), "/tools/spatula/nodes")) << pipeline;
  }
}

}  // namespace
}  // namespace fissure::programs::cost_test
