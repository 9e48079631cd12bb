// A scenario's meshes and logs are read once in a process, however many of its parts name them and whoever
// asks: check, plan or run.
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "check/run_plan.h"
#include "measure/probes.h"
#include "mesh/primitives.h"
#include "run/run.h"

namespace fissure::prepared_scenario_test {

namespace {

namespace fs = std::filesystem;

/// How often a file has been opened, by whatever process, since this object was made. Openings that follow
/// each other count one by one, because between them the file is closed.
class OpenCounter {
 public:
  explicit OpenCounter(const fs::path& file) : notices_(::inotify_init1(IN_NONBLOCK)) {
    if (::inotify_add_watch(notices_, file.c_str(), IN_OPEN | IN_CLOSE) < 0)
      throw std::runtime_error("no watch on " + file.string());
  }
  ~OpenCounter() { ::close(notices_); }
  OpenCounter(const OpenCounter&) = delete;
  OpenCounter& operator=(const OpenCounter&) = delete;

  int count() {
    std::array<char, 4096> bytes{};
    for (ssize_t size = 0; (size = ::read(notices_, bytes.data(), bytes.size())) > 0;) {
      for (std::size_t at = 0; at < static_cast<std::size_t>(size);) {
        inotify_event event{};
        std::memcpy(&event, &bytes[at], sizeof event);
        if (event.mask & IN_OPEN) ++count_;
        at += sizeof event + event.len;
      }
    }
    return count_;
  }

 private:
  int notices_;
  int count_ = 0;
};

/// A cube of 60 mm, one of whose triangles is there twice: to be repaired.
std::string cubeText() {
  const TriangleMesh cube = makeBox({60, 60, 60});
  std::string text = "OFF\n8 13 0\n";
  const auto add = [&](const auto& numbers, const std::string& before) {
    text += before;
    for (const auto number : numbers) text += " " + std::to_string(number);
    text += "\n";
  };
  for (const Vec3& vertex : cube.vertices_m) add(vertex, "");
  for (const Face& face : cube.faces) add(face, "3");
  add(cube.faces.front(), "3");
  return text;
}

/// A body and a tool of one mesh file in different states of repair, the body partly fixed and with a gauge,
/// and two tools that replay one log.
constexpr const char* kScenario =
    "format: 1\n"
    "name: once\n"
    "description: Two tools over a cube.\n"
    "time: {step_s: 0.001}\n"
    "bodies:\n"
    "  - name: cube\n"
    "    shape: {type: file, file: cube.off, unit: mm, repairs: [drop_duplicate_faces]}\n"
    "    position_m: [0, 0.03, 0]\n"
    "    fixed: [{below_m: 0.001}]\n"
    "    gauges: [{name: top, box: {min_m: [-1, 0.05, -1], max_m: [1, 0.1, 1]}}]\n"
    "    mass_kg: 0.1\n"
    "    material: {linear_stiffness: 0.5}\n"
    "tools:\n"
    "  - name: block\n"
    "    shape: {type: file, file: cube.off, unit: mm, repairs: [drop_duplicate_faces], max_edge_m: 0.07}\n"
    "    motion: {type: replay, file: hand.csv, time_column: t, mapping: {origin_scene_m: [0, 0.2, 0]}}\n"
    "  - name: plate\n"
    "    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"
    "    nodes: {resolution: [4, 4]}\n"
    "    motion: {type: replay, file: hand.csv, time_column: t, mapping: {origin_scene_m: [0, 0.1, 0]}}\n"
    "pipelines: [{pipeline: default}, {pipeline: fukuhara}]\n"
    "force: [{name: hc, model: hunt_crossley}]\n";

struct RowCounter : RecordSink {
  std::size_t rows = 0;
  Summary summary;
  void forceInputs(const State&) override {}
  void append(const RecordRow&) override { ++rows; }
  void snapshot(const State&) override {}
  void frame(double, const Image&) override {}
  void finish(const RunStatus&, const Summary& values) override { summary = values; }
};

class PreparedScenarioTest : public testing::Test {
 protected:
  PreparedScenarioTest() {
    std::string name = (fs::temp_directory_path() / "fissure_check_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    write("cube.off", cubeText());
    write("hand.csv", "t,x,y,z\n0,0,0,0\n0.01,0,0.001,0\n0.02,0,0.002,0\n");
    write("s.yaml", kScenario);
  }
  ~PreparedScenarioTest() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  fs::path folder_;
};

TEST_F(PreparedScenarioTest, ACheckReadsEachFileOnceBesideTheTrialsApart) {
  OpenCounter mesh(folder_ / "cube.off"), log(folder_ / "hand.csv");
  const CheckedScenario checked = checkScenario(folder_ / "s.yaml");
  EXPECT_EQ(mesh.count(), 1 + 2) << "here, and for each of the two shapes in a process that may crash";
  EXPECT_EQ(log.count(), 1);
  EXPECT_EQ(checked.steps, 20);
  planRuns(checked);
  EXPECT_EQ(mesh.count(), 1 + 2);
  EXPECT_EQ(log.count(), 1);
}

TEST_F(PreparedScenarioTest, APlanAndARunNeedNoFileAnyMore) {
  CheckedScenario checked = checkScenario(folder_ / "s.yaml");
  ASSERT_TRUE(fs::remove(folder_ / "cube.off"));
  ASSERT_TRUE(fs::remove(folder_ / "hand.csv"));
  const std::vector<RunPlan> plans = planRuns(checked);
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].nodes, 0) << "the default pipeline uses none";
  EXPECT_GT(plans[1].nodes, 32) << "32 of the plate";

  const Scenario& scenario = checked.loaded.scenario;
  fissure::Run run(scenario, scenario.pipelines[1], std::move(checked.prepared));
  EXPECT_EQ(run.scene().nodeCount(), plans[1].nodes);
  EXPECT_EQ(run.scene().bodies[0].fixed_vertices.size(), 4u);
  std::vector<std::unique_ptr<Probe>> probes = makeProbes(scenario, run.scene());
  const RecordLayout layout = declareLayout(probes);
  RowCounter sink;
  run.execute({.sink = sink, .probes = probes, .layout = layout, .make_frame_source = {}, .progress = {}});
  EXPECT_EQ(sink.rows, 21u);
  bool repaired = false;
  for (const SummaryValue& value : sink.summary) repaired |= value.name == "repairs";
  EXPECT_TRUE(repaired);
}

TEST_F(PreparedScenarioTest, ARunThroughAPipelineWithoutNodesHasNone) {
  const LoadedScenario loaded = loadScenario(folder_ / "s.yaml");
  const fissure::Run run(loaded.scenario, loaded.scenario.pipelines[0],
                         prepareScenario(loaded.scenario, true));
  EXPECT_EQ(run.scene().nodeCount(), 0);
  for (const SceneTool& tool : run.scene().tools) EXPECT_EQ(tool.first_node, 0);
}

}  // namespace

}  // namespace fissure::prepared_scenario_test
