// Tools on a coupling that the contacts push: one force for tool and tissue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recorded_run.h"

namespace fissure::reaction_coupling_test {

namespace {

constexpr double kStep_s = 0.001;

/// A plate led by a hand 8 mm into a ball of 10 kPa about the origin, and held.
class ReactionRun : public RecordedRun {
 protected:
  ReactionRun() {
    scenario.name = "pushed";
    scenario.time.step_s = kStep_s;
    scenario.world.gravity_m_s2 = Vec3::Zero();
    scenario.measure.certify = true;
    BodySettings ball;
    ball.name = "ball";
    ball.shape = SphereShape{.radius_m = 0.03, .subdivisions = 2};
    ball.model = BodyModel::elastic;
    ball.elastic.youngs_modulus_Pa = 10e3;
    ball.elastic.viscosity_Pa_s = 5;
    ball.elastic.mass_damping_1_s = 10;
    ball.fixed = {FixedRegion{.below_m = -0.02, .box = {}}};
    scenario.bodies = {ball};
    ToolSettings tool;
    tool.name = "plate";
    tool.shape = BoxShape{Vec3(0.06, 0.004, 0.06)};
    tool.nodes.resolution = {16, 16};
    tool.coupling =
        CouplingSettings{.mass_kg = 0.05, .stiffness_N_m = 500, .damping_N_s_m = 5, .force = "reaction"};
    tool.motion =
        ScriptMotion{.start_m = Vec3(0, 0.034, 0), .segments = {moves(Vec3(0, 0.024, 0), 0.1), holds(0.4)}};
    scenario.tools = {tool};
    scenario.pipelines = {{.name = "swept", .pipeline = PipelineKind::swept}};
  }

  void holdFor(double hold_s) {
    std::get<ScriptMotion>(scenario.tools[0].motion).segments = {moves(Vec3(0, 0.024, 0), 0.1),
                                                                 holds(hold_s)};
  }
  void expectNothingInside() const {
    EXPECT_EQ(std::get<long long>(seen.summary.at("uncertified_steps").value), 0);
    EXPECT_LE(seen.number("max_penetration_depth_m"), 1e-6);
  }
  CouplingSettings& coupling() { return *scenario.tools[0].coupling; }
};

// The lag of the spring, what the hand feels and what the tissue gives are one force.
TEST_F(ReactionRun, AtRestTheSpringHoldsTheReaction) {
  for (const PipelineKind pipeline : {PipelineKind::swept, PipelineKind::fukuhara}) {
    scenario.pipelines = {{.name = "p", .pipeline = pipeline}};
    execute();
    const State& state = states_.back();
    const Vec3 &reaction_N = state.contact.reaction_on_tool_N, &hand_N = state.couplings[0].force_on_tool_N;
    const Vec3 spring_N =
        coupling().stiffness_N_m * (state.couplings[0].target_m - state.tools[0].pose.position_m);
    EXPECT_GT(reaction_N.y(), 0.5);
    EXPECT_LT((hand_N + reaction_N).norm(), 1e-3 * reaction_N.norm());
    EXPECT_LT((spring_N + reaction_N).norm(), 1e-3 * reaction_N.norm());
    if (pipeline == PipelineKind::swept) expectNothingInside();
  }
}

TEST_F(ReactionRun, MomentumOfToolAndTissueIsTheCouplings) {
  scenario.bodies[0].fixed.clear();
  scenario.bodies[0].elastic.mass_damping_1_s = 0;
  holdFor(0.1);
  execute();
  const double mass_kg = coupling().mass_kg;
  double given_N_s = 0;
  for (std::size_t i = 1; i < states_.size(); ++i) {
    const State &now = states_[i], &before = states_[i - 1];
    const Vec3 tissue_N_s = now.volume->momentum_kg_m_s - before.volume->momentum_kg_m_s;
    const Vec3 tool_N_s = mass_kg * (now.tools[0].velocity_m_s - before.tools[0].velocity_m_s);
    const Vec3 hand_N_s = kStep_s * now.couplings[0].force_on_tool_N;
    ASSERT_LE((tissue_N_s + tool_N_s - hand_N_s).norm(), 1e-13) << i;
    given_N_s += tissue_N_s.norm();
  }
  EXPECT_GT(given_N_s, 1e-3);
}

TEST_F(ReactionRun, ALightToolIsStable) {
  coupling().mass_kg = 0.001;
  for (const double damping_N_s_m : {5.0, 0.0}) {
    coupling().damping_N_s_m = damping_N_s_m;
    execute();
    expectNothingInside();
    EXPECT_LT(seen.number("plate_max_coupling_force_N"), 3);
    EXPECT_LT(states_.back().tools[0].velocity_m_s.norm(), 1e-3);
  }
}

TEST_F(ReactionRun, AHeavyToolIsStable) {
  coupling() = {.mass_kg = 1000, .stiffness_N_m = 1e8, .damping_N_s_m = 6e5, .force = "reaction"};
  holdFor(0.1);
  execute();
  expectNothingInside();
  EXPECT_NEAR(states_.back().tools[0].pose.position_m.y(), 0.024, 1e-5);
}

// At 1 ms, where the shell's springs give in a step: the same promises.
TEST_F(ReactionRun, AShellPushesItToo) {
  scenario.bodies = {softSphere()};
  scenario.bodies[0].fixed = {FixedRegion{.below_m = -0.02, .box = {}}};
  for (const double mass_kg : {0.001, 0.05, 1000.0}) {
    coupling() = {.mass_kg = mass_kg, .stiffness_N_m = 3000, .damping_N_s_m = 20, .force = "reaction"};
    execute();
    expectNothingInside();
    EXPECT_LT(states_.back().tools[0].velocity_m_s.norm(), 0.02);
  }
}

TEST_F(ReactionRun, WhileTissueSettlesItWaits) {
  scenario.time.settle_s = 0.01;
  holdFor(0.1);
  execute();
  EXPECT_EQ(states_.front().tools[0].pose.position_m, Vec3(0, 0.034, 0));
  EXPECT_EQ(states_.front().couplings[0].force_on_tool_N, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace fissure::reaction_coupling_test
