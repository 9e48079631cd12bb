#include <gtest/gtest.h>

#include <cmath>

#include "recorded_run.h"

namespace fissure::coupling_test {

namespace {

constexpr double kStep_s = 0.001;

/// A plate of 50 g, led by a hand into a sphere on the ground and held; one law pushes it, another does not.
class CoupledRun : public RecordedRun {
 protected:
  CoupledRun() {
    scenario.name = "coupled";
    scenario.time.step_s = kStep_s;
    scenario.bodies = {softSphere()};
    scenario.bodies[0].position_m = Vec3(0, 0.03, 0);
    scenario.ground = GroundSettings{};
    ToolSettings tool;
    tool.name = "plate";
    tool.shape = BoxShape{Vec3(0.06, 0.004, 0.06)};
    tool.nodes.resolution = {16, 16};
    tool.coupling =
        CouplingSettings{.mass_kg = 0.05, .stiffness_N_m = 3000, .damping_N_s_m = 20, .force = "felt"};
    tool.motion =
        ScriptMotion{.start_m = Vec3(0, 0.066, 0), .segments = {moves(Vec3(0, 0.05, 0), 0.2), holds(1)}};
    scenario.tools = {tool};
    scenario.force = {{.name = "other", .model = ForceModel::linear_elastic, .coefficients = {.k = 10}},
                      {.name = "felt", .model = ForceModel::hunt_crossley}};
    scenario.pipelines = {{.name = "full", .pipeline = PipelineKind::fukuhara}};
  }

  std::size_t column(const char* series) const { return layout.find(series)->first_column; }
  static Vec3 vector(const RecordRow& row, std::size_t column) {
    return {row[column], row[column + 1], row[column + 2]};
  }
};

TEST_F(CoupledRun, AtRestTheHandHoldsWhatTheLawSays) {
  execute();
  const State& state = states_.back();
  ASSERT_EQ(state.couplings.size(), 1u);
  const Vec3 &hand_N = state.couplings[0].force_on_tool_N, &tissue_N = state.tool_forces_N[1];
  EXPECT_GT(tissue_N.y(), 5);
  EXPECT_LT((hand_N + tissue_N).norm(), 0.01 * tissue_N.norm());
  const Vec3 lag_m = state.couplings[0].target_m - state.tools[0].pose.position_m;
  EXPECT_LT((lag_m * 3000 - hand_N).norm(), 0.01 * hand_N.norm());
  EXPECT_LT(seen.number("max_penetration_depth_m"), 0.0005);
}

// Every step by itself, from what the result holds: m a = spring + damper + the force of the step before.
TEST_F(CoupledRun, EachStepIsNewtonsLawOfWhatIsRecorded) {
  execute();
  const std::size_t place = column("tool_position"), target = column("coupling_target"),
                    hand = column("coupling_force"), tissue = column("tool_force") + 3;
  const CouplingSettings& settings = *scenario.tools[0].coupling;
  double largest_N = 0;
  for (std::size_t i = 2; i < seen.rows.size(); ++i) {
    const RecordRow &now = seen.rows[i], &before = seen.rows[i - 1], &first = seen.rows[i - 2];
    const Vec3 velocity_m_s = (vector(now, place) - vector(before, place)) / kStep_s;
    const Vec3 velocity_before_m_s = (vector(before, place) - vector(first, place)) / kStep_s;
    const Vec3 hand_m_s = (vector(now, target) - vector(before, target)) / kStep_s;
    const Vec3 pushed_N = settings.mass_kg * (velocity_m_s - velocity_before_m_s) / kStep_s;
    const Vec3 coupling_N = settings.stiffness_N_m * (vector(now, target) - vector(now, place)) +
                            settings.damping_N_s_m * (hand_m_s - velocity_m_s);
    ASSERT_LT((coupling_N - vector(now, hand)).norm(), 1e-8) << i;
    ASSERT_LT((coupling_N + vector(before, tissue) - pushed_N).norm(), 1e-6) << i;
    largest_N = std::max(largest_N, vector(now, hand).norm());
  }
  EXPECT_EQ(seen.number("plate_max_coupling_force_N"), largest_N);
  EXPECT_EQ(seen.number("plate_final_lag_m"),
            (vector(seen.rows.back(), target) - vector(seen.rows.back(), place)).norm());
  EXPECT_EQ(layout.find("coupling_saturated"), nullptr) << "no device";
  EXPECT_GE(seen.number("plate_max_lag_m"), seen.number("plate_final_lag_m"));
}

TEST_F(CoupledRun, OthersAreWhereTheirMotionSays) {
  scenario.tools.insert(scenario.tools.begin(), scenario.tools[0]);
  scenario.tools[0].name = "led";
  scenario.tools[0].coupling.reset();
  scenario.tools[0].motion =
      ScriptMotion{.start_m = Vec3(0.2, 0.1, 0), .segments = {moves(Vec3(0.2, 0.05, 0), 0.1)}};
  execute();
  EXPECT_EQ(states_.back().tools[0].pose.position_m, Vec3(0.2, 0.05, 0));
  EXPECT_EQ(layout.axis("coupling").labels, std::vector<std::string>{"plate"});
  EXPECT_EQ(states_.back().couplings[0].tool, 1u);
  EXPECT_GT(seen.number("plate_final_lag_m"), 0.001);
  EXPECT_FALSE(seen.summary.contains("led_final_lag_m"));
}

TEST_F(CoupledRun, BesideAClampItIsTheRightToolThatIsPushed) {
  ToolSettings clamp = scenario.tools[0];
  clamp.name = "clamp";
  clamp.coupling.reset();
  clamp.clamp = ClampSettings{.jaw_position_m = {0.05, 0, 0}};
  clamp.motion = ScriptMotion{.start_m = Vec3(0, 0.3, 0), .segments = {holds(0.1)}};
  scenario.tools.insert(scenario.tools.begin(), clamp);
  execute();
  ASSERT_EQ(states_.back().tools.size(), 3u);
  EXPECT_EQ(states_.back().couplings[0].tool, 2u);
  EXPECT_EQ(states_.back().tools[0].pose.position_m.y(), 0.3);
  EXPECT_GT(seen.number("plate_final_lag_m"), 0.001);
}

// 5 mm to one side in 10 ms, in free air: the damper alone pulls with more than 5 N.
TEST_F(CoupledRun, WhatTheDeviceCannotGiveIsCounted) {
  scenario.tools[0].force_limit_N = 5;
  scenario.tools[0].motion =
      ScriptMotion{.start_m = Vec3(0, 0.1, 0), .segments = {moves(Vec3(0.005, 0.1, 0), 0.01), holds(0.1)}};
  execute();
  const std::size_t force = column("coupling_force"), flag = column("coupling_saturated");
  long long beyond = 0;
  for (const RecordRow& row : seen.rows) {
    EXPECT_EQ(row[flag], vector(row, force).norm() > 5 ? 1 : 0);
    beyond += vector(row, force).norm() > 5;
  }
  EXPECT_GT(beyond, 2);
  EXPECT_EQ(layout.find("saturated"), nullptr) << "of the law, which no hand feels";
  EXPECT_EQ(std::get<long long>(seen.summary.at("plate_coupling_saturated_steps").value), beyond);
}

TEST_F(CoupledRun, TheHandWaitsWhileTissueSettles) {
  scenario.time.settle_s = 0.05;
  execute();
  EXPECT_EQ(states_.front().tools[0].pose.position_m, Vec3(0, 0.066, 0));
  EXPECT_EQ(states_.front().couplings[0].force_on_tool_N, Vec3(0, 0, 0));
}

TEST_F(CoupledRun, AForceThatIsNoNumberEndsTheRunWithItsStatus) {
  scenario.force[1].coefficients.k = 1e308;
  fissure::Run run(scenario, scenario.pipelines[0],
                   prepareScenario(scenario, scenario.pipelines[0].usesNodes()));
  std::vector<std::unique_ptr<Probe>> probes = makeProbes(scenario, run.scene());
  layout = declareLayout(probes);
  run.execute({.sink = seen, .probes = probes, .layout = layout, .make_frame_source = {}, .progress = {}});
  EXPECT_EQ(nameOf(seen.status.end), "non_finite");
  EXPECT_NE(seen.status.detail.find("tool 0 is not finite"), std::string::npos) << seen.status.detail;
}

TEST_F(CoupledRun, NothingIsRecordedWithoutOne) {
  scenario.tools[0].coupling.reset();
  execute();
  EXPECT_EQ(layout.find("coupling_force"), nullptr);
  EXPECT_TRUE(states_.back().couplings.empty());
  EXPECT_FALSE(seen.summary.contains("plate_final_lag_m"));
}

}  // namespace
}  // namespace fissure::coupling_test
