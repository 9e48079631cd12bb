// Tools that contacts push: what tissue gains they lose, and one of endless mass is a tool that is led.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "engine/simulation.h"
#include "scene/build_scene.h"

namespace fissure::pushed_tool_test {

namespace {

constexpr double kStep_s = 0.001;

/// A soft sphere of 30 mm and 100 g at the origin, not damped, and a plate above it that flies freely.
class World {
 public:
  World(const PipelineSettings& entry, double tool_inverse_mass_1_kg, const Vec3& tool_velocity_m_s)
      : entry_(entry), inverse_masses_{tool_inverse_mass_1_kg}, velocity_m_s_(tool_velocity_m_s) {
    scenario_.time.step_s = kStep_s;
    scenario_.world.gravity_m_s2 = Vec3::Zero();
    scenario_.bodies.resize(1);
    BodySettings& body = scenario_.bodies[0];
    body.name = "sphere";
    body.shape = SphereShape{};
    body.mass_kg = 0.1;
    body.material.linear_stiffness = 0.5;
    body.solver.pose_matching = 0.02;
    body.solver.position_iterations = 10;
    body.solver.dynamic_friction = 0.5;
    scenario_.tools.resize(1);
    scenario_.tools[0].name = "plate";
    scenario_.tools[0].shape = BoxShape{size_m_};
    scenario_.tools[0].nodes.resolution = {16, 16};
    scenario_.tools[0].friction = 0.8;
    scene_ = buildScene(scenario_, entry_.usesNodes());
    simulation_ = makeSimulation(scenario_, entry_, scene_, {{.position_m = Vec3(0, 0.037, 0)}});
  }

  void step() {
    Pose pose = tool().pose;
    pose.position_m += kStep_s * velocity_m_s_;
    if (inverse_masses_[0] > 0)
      simulation_->step({pose}, inverse_masses_);
    else
      simulation_->step({pose});
    velocity_m_s_ = tool().velocity_m_s;
  }

  const State& state() const { return simulation_->state(); }
  const ToolState& tool() const { return state().tools[0]; }
  const Vec3& velocity_m_s() const { return velocity_m_s_; }  ///< of the tool
  Vec3 momentum() const {
    Vec3 sum = velocity_m_s_ / inverse_masses_[0];
    for (std::size_t i = 0; i < state().masses_kg.size(); ++i)
      sum += state().masses_kg[i] * state().velocities_m_s[i];
    return sum;
  }
  bool toolHoldsTissue() const {
    return std::any_of(state().positions_m.begin(), state().positions_m.end(), [&](const Vec3& point_m) {
      return (tool().pose.toBody(point_m).array().abs() < 0.5 * size_m_.array()).all();
    });
  }
  long long count(const std::string& name) const {
    const Summary counters = simulation_->counters();
    const auto at = std::find_if(counters.begin(), counters.end(),
                                 [&](const SummaryValue& value) { return value.name == name; });
    return std::get<long long>(at->value);
  }

 private:
  Vec3 size_m_{0.1, 0.01, 0.1};
  Scenario scenario_;
  PipelineSettings entry_;
  Scene scene_;
  std::vector<double> inverse_masses_;
  Vec3 velocity_m_s_;
  std::unique_ptr<Simulation> simulation_;
};

class PushedBy : public testing::TestWithParam<PipelineKind> {
 protected:
  PipelineSettings entry() const { return {.name = "p", .pipeline = GetParam()}; }
};

std::string pipelineName(const testing::TestParamInfo<PipelineKind>& info) {
  return std::string(traitsOf(info.param).name);
}

TEST_P(PushedBy, WhatTissueGainsTheToolLoses) {
  World world(entry(), 1 / 0.05, Vec3(0.1, -0.5, 0));
  for (int i = 0; i < 400; ++i) {
    const Vec3 before = world.momentum();
    world.step();
    ASSERT_LE((world.momentum() - before).norm(), 1e-13) << i;
  }
  EXPECT_GT(world.velocity_m_s().y(), -0.4) << "no contact, no test";
  EXPECT_LT(world.velocity_m_s().x(), 0.1) << "it rubs";
}

TEST_P(PushedBy, OneOfEndlessMassIsLed) {
  World pushed(entry(), 1e-15, Vec3(0, -0.2, 0)), led(entry(), 0, Vec3(0, -0.2, 0));
  double reaction_N = 0;
  for (int i = 0; i < 150; ++i) {
    pushed.step();
    led.step();
    reaction_N = std::max(reaction_N, led.state().contact.reaction_on_tool_N.norm());
  }
  EXPECT_GT(reaction_N, 1) << "no contact, no test";
  for (std::size_t v = 0; v < led.state().positions_m.size(); ++v)
    ASSERT_LE((pushed.state().positions_m[v] - led.state().positions_m[v]).norm(), 1e-6) << v;
}

TEST_P(PushedBy, OneOfAGramIsStoppedAndStaysOutside) {
  World world(entry(), 1 / 0.001, Vec3(0, -0.5, 0));
  for (int i = 0; i < 400; ++i) {
    world.step();
    ASSERT_FALSE(world.toolHoldsTissue()) << i;
    ASSERT_LE(world.velocity_m_s().norm(), 1) << i;
  }
  EXPECT_GT(world.velocity_m_s().y(), 0);
}

INSTANTIATE_TEST_SUITE_P(Shell, PushedBy, testing::Values(PipelineKind::fukuhara, PipelineKind::swept),
                         pipelineName);

// Without a response all that crosses is stopped on its path.
TEST(PushedTool, WhatStopsTissuePushesTheTool) {
  World world({.name = "p", .pipeline = PipelineKind::swept, .rounds = 0}, 1 / 0.05, Vec3(0, -5, 0));
  for (int i = 0; i < 100; ++i) {
    const Vec3 before = world.momentum();
    world.step();
    ASSERT_LE((world.momentum() - before).norm(), 1e-13) << i;
    ASSERT_FALSE(world.toolHoldsTissue()) << i;
  }
  EXPECT_GT(world.count("truncated_steps"), 0);
  EXPECT_GT(world.velocity_m_s().y(), -4.9);
}

TEST(PushedTool, BulletsOwnContactAndPrescribedPushNone) {
  for (const PipelineKind pipeline :
       {PipelineKind::default_sdf, PipelineKind::cluster, PipelineKind::prescribed})
    EXPECT_THROW(World({.name = "p", .pipeline = pipeline}, 20, Vec3::Zero()).step(), std::invalid_argument);
  EXPECT_THROW(World({.name = "p", .pipeline = PipelineKind::raycast}, 20, Vec3::Zero()).step(),
               std::invalid_argument)
      << "response none";
}

}  // namespace
}  // namespace fissure::pushed_tool_test
