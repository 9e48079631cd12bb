#include "run/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/steps.h"
#include "scene/build_scene.h"

namespace fissure::run_test {

namespace {

/// Keeps everything a run hands out.
struct MemorySink : RecordSink {
  std::vector<RecordRow> rows;
  std::map<std::size_t, int> inputs_before_row;
  std::vector<double> snapshot_times, frame_times;
  RunStatus status;
  Summary summary;
  bool finished = false;
  void forceInputs(const State&) override { ++inputs_before_row[rows.size()]; }
  void append(const RecordRow& row) override { rows.push_back(row); }
  void snapshot(const State& state) override { snapshot_times.push_back(state.time_s); }
  void frame(double time_s, const Image&) override { frame_times.push_back(time_s); }
  void finish(const RunStatus& s, const Summary& values) override {
    status = s;
    summary = values;
    finished = true;
  }
};

/// Notes the tool's height and the step's wall time of every state.
struct HeightProbe : Probe {
  std::size_t column = 0;
  void declare(RecordLayout& layout) override {
    layout.addAxis({"what", {"height", "step_us"}});
    column = layout.add({.name = "seen", .units = "1", .long_name = "what the probe saw", .axes = {"what"}});
  }
  void sample(const State& state, RecordRow& row) override {
    row[column] = state.tools.empty() ? 0 : state.tools[0].pose.position_m.y();
    row[column + 1] = state.timing.step_us;
  }
  void summarize(Summary& summary) const override { summary.push_back({"probed", 1LL}); }
};

struct CountingFrames : FrameSource {
  std::vector<std::vector<std::string>>* lines;
  explicit CountingFrames(std::vector<std::vector<std::string>>* l) : lines(l) {}
  Image draw(const State&, const std::vector<std::string>& text) override {
    lines->push_back(text);
    return {.width_px = 1, .height_px = 1, .rgb = {0, 0, 0}};
  }
  std::vector<std::pair<std::string, std::string>> versions() const override {
    return {{"gl_version", "counting 1.0"}};
  }
};

/// A sphere and a blade that moves 10 mm down in 0.1 s, then rests 0.05 s; dt = 10 ms.
class RunTest : public testing::Test {
 protected:
  RunTest() {
    scenario.name = "test";
    scenario.time = {.step_s = 0.01};
    BodySettings body;
    body.name = "sphere";
    body.shape = SphereShape{.radius_m = 0.03, .subdivisions = 1};
    scenario.bodies = {body};
    ToolSettings tool;
    tool.name = "blade";
    MotionSegment down, rest;
    down.move_to_m = Vec3(0, 0.09, 0);
    down.speed_m_s = 0.1;
    rest.hold_s = 0.05;
    tool.motion = ScriptMotion{.start_m = Vec3(0, 0.1, 0), .segments = {down, rest}};
    scenario.tools = {tool};
    scenario.pipelines = {{.name = "full", .pipeline = PipelineKind::fukuhara}};
  }

  RunStatus execute() {
    fissure::Run run(scenario, scenario.pipelines[0],
                     prepareScenario(scenario, scenario.pipelines[0].usesNodes()));
    std::vector<std::unique_ptr<Probe>> probes;
    probes.push_back(std::make_unique<HeightProbe>());
    const RecordLayout layout = declareLayout(probes);
    EXPECT_EQ(layout.columns(), 3u);
    return run.execute({.sink = sink,
                        .probes = probes,
                        .layout = layout,
                        .make_frame_source = [&](const State&) -> std::unique_ptr<FrameSource> {
                          ++frame_sources;
                          return std::make_unique<CountingFrames>(&frame_lines);
                        },
                        .progress =
                            [&](std::int64_t step, std::int64_t steps) {
                              progress.push_back({step, steps});
                            }});
  }

  Scenario scenario;
  MemorySink sink;
  int frame_sources = 0;
  std::vector<std::vector<std::string>> frame_lines;
  std::vector<std::pair<std::int64_t, std::int64_t>> progress;
};

TEST_F(RunTest, RowsAreTheInitialStateAndEveryStepAtStepTimesDt) {
  EXPECT_EQ(nameOf(execute().end), "ok");
  ASSERT_EQ(sink.rows.size(), 16u) << "0.15 s / 0.01 s, and time zero";
  for (std::size_t i = 0; i < sink.rows.size(); ++i) {
    EXPECT_EQ(sink.rows[i][0], static_cast<double>(i) * 0.01);
    const double height = std::max(0.1 - 0.1 * static_cast<double>(i) * 0.01, 0.09);
    EXPECT_NEAR(sink.rows[i][1], height, 1e-15) << "the pose at the END of the step";
  }
  EXPECT_TRUE(std::isnan(sink.rows[0][2])) << "no step, no time";
  EXPECT_GT(sink.rows[1][2], 0);
  EXPECT_TRUE(sink.finished);
  EXPECT_EQ(progress.size(), 15u);
  EXPECT_EQ(progress.back(), std::make_pair(std::int64_t{15}, std::int64_t{15}));
}

TEST_F(RunTest, InputsOfForceLawsComeOnceBeforeEachRowAndOnlyWhereAskedFor) {
  scenario.force = {{.name = "hc", .model = ForceModel::hunt_crossley}};
  execute();
  EXPECT_TRUE(sink.inputs_before_row.empty());
  scenario.record.force_inputs = true;
  sink = {};
  execute();
  ASSERT_EQ(sink.inputs_before_row.size(), sink.rows.size());
  for (const auto& [row, times] : sink.inputs_before_row) EXPECT_EQ(times, 1) << row;
}

TEST_F(RunTest, SaysWhatMadeIt) {
  const auto said = [&](const std::string& name) -> std::string {
    for (const SummaryValue& value : sink.summary) {
      if (value.name == name) return std::get<std::string>(value.value);
    }
    return "nothing";
  };
  execute();
  EXPECT_EQ(said("provenance/engine_version"), "Bullet 3.24, double precision");
  EXPECT_EQ(said("provenance/gl_version"), "nothing") << "no frame, no renderer";
  scenario.record.frames = FrameSettings{};
  execute();
  EXPECT_EQ(said("provenance/gl_version"), "counting 1.0");
}

TEST_F(RunTest, SettlingIsSimulatedButNotRecorded) {
  scenario.world.gravity_m_s2 = Vec3(0, -10, 0);
  scenario.time.settle_s = 0.05;

  execute();
  EXPECT_EQ(sink.rows.size(), 16u);
  EXPECT_EQ(sink.rows[0][1], 0.1) << "the tool waits at its first pose";
}

TEST_F(RunTest, SnapshotsAndFramesComeAtTheirIntervals) {
  scenario.record.snapshots_every_s = 0.03;
  scenario.record.frames = FrameSettings{.every_s = 0.05};
  execute();
  ASSERT_EQ(sink.snapshot_times.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(sink.snapshot_times[i], 0.03 * static_cast<double>(i), 1e-12);
  ASSERT_EQ(sink.frame_times.size(), 4u);
  EXPECT_EQ(frame_sources, 1);
  EXPECT_EQ(frame_lines[0], (std::vector<std::string>{"full", "t = 0.000 s"}));
}

TEST_F(RunTest, WithoutFramesNoRendererIsMade) {
  execute();
  EXPECT_EQ(frame_sources, 0);
  EXPECT_TRUE(sink.snapshot_times.empty());
}

// The positions stay finite: after one step all vertices fall at 1e4 m/s, and 1e306 kg of them have 5e313 J.
TEST_F(RunTest, AKineticEnergyThatIsNotFiniteEndsTheRun) {
  scenario.tools.clear();
  scenario.bodies[0].mass_kg = 1e306;
  scenario.world.gravity_m_s2 = Vec3(0, -1e6, 0);
  scenario.time.duration_s = 0.1;
  scenario.pipelines = {{.name = "default", .pipeline = PipelineKind::default_sdf}};
  const RunStatus status = execute();
  EXPECT_EQ(nameOf(status.end), "non_finite");
  EXPECT_EQ(status.detail, "the kinetic energy of the tissue is not finite at step 1 (t = 0.01 s)");
  EXPECT_EQ(sink.rows.size(), 2u);
}

TEST_F(RunTest, ANonFiniteStateEndsTheRunAndSaysWhenAndWhere) {
  scenario.bodies[0].solver.pressure = 1e200;  // blows the body up until squared lengths overflow
  scenario.world.max_displacement_m = 1e300;
  const RunStatus status = execute();
  EXPECT_EQ(nameOf(status.end), "non_finite");
  EXPECT_NE(status.detail.find("tissue vertex"), std::string::npos) << status.detail;
  EXPECT_NE(status.detail.find("step"), std::string::npos);
  EXPECT_EQ(nameOf(sink.status.end), "non_finite");
  EXPECT_LT(sink.rows.size(), 16u);
  bool found = false;
  for (const SummaryValue& value : sink.summary) {
    if (value.name != "non_finite_at_step") continue;
    found = true;
    EXPECT_EQ(std::get<long long>(value.value), static_cast<long long>(sink.rows.size()) - 1);
  }
  EXPECT_TRUE(found);
}

TEST_F(RunTest, ABodyTenKilometresAwayIsNoResult) {
  scenario.world.gravity_m_s2 = Vec3(0, -1e7, 0);
  EXPECT_EQ(nameOf(execute().end), "non_finite");
  EXPECT_NE(sink.status.detail.find("10 km"), std::string::npos) << sink.status.detail;
}

TEST_F(RunTest, AStatedDurationCutsTheMotion) {
  scenario.time.duration_s = 0.04;
  execute();
  EXPECT_EQ(sink.rows.size(), 5u);
}

TEST(BuildScene, OnlyPipelinesWithNodesGetNodes) {
  Scenario scenario;
  BodySettings body;
  body.name = "a";
  body.shape = SphereShape{.radius_m = 0.03, .subdivisions = 1};
  scenario.bodies = {body, body};
  ToolSettings tool;
  tool.nodes.resolution = {4, 3};
  scenario.tools = {tool, tool};
  const Scene without = buildScene(scenario, false);
  EXPECT_EQ(without.nodeCount(), 0);
  EXPECT_EQ(without.bodies[1].first_vertex, 18);
  EXPECT_EQ(without.bodies[1].first_face, 32);
  const Scene with = buildScene(scenario, true);
  EXPECT_EQ(with.nodeCount(), 48);
  EXPECT_EQ(with.tools[1].first_node, 24);
  EXPECT_FALSE(with.ground_height_m.has_value());
}

// The rule for "every so often": due in the first step that reaches a new multiple.
TEST(IsDue, FollowsMultiplesOfTheIntervalWithoutDrift) {
  int due = 0;
  for (int step = 1; step <= 10000; ++step) due += isDue(step, 0.001, 0.01) ? 1 : 0;
  EXPECT_EQ(due, 1000);
  EXPECT_TRUE(isDue(0, 0.001, 5));
  EXPECT_TRUE(isDue(10, 0.001, 0.01));
  EXPECT_FALSE(isDue(9, 0.001, 0.01));
  EXPECT_FALSE(isDue(11, 0.001, 0.01));
  due = 0;
  for (int step = 1; step <= 60; ++step) due += isDue(step, 1.0 / 60, 0.01) ? 1 : 0;
  EXPECT_EQ(due, 60) << "an interval shorter than the step: every step";
}

}  // namespace
}  // namespace fissure::run_test
