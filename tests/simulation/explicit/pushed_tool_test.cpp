// Tools that contacts push in the substeps of elastic tissue: momentum, energy, and the limit of a led tool.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "explicit/elastic_simulation.h"
#include "scene/build_scene.h"

namespace fissure::pushed_tool_test {

namespace {

constexpr double kStep_s = 0.001;

struct Settings {
  PipelineKind pipeline = PipelineKind::swept;
  double tool_mass_kg = 0;
  Vec3 tool_velocity_m_s = Vec3::Zero();
  double tool_height_m = 0.037;
  bool held = false;  ///< the ball below
};

/// A ball of 30 mm, 113 g and 10 kPa about the origin, and a plate above it that flies freely.
class World {
 public:
  explicit World(const Settings& settings)
      : mass_kg_(settings.tool_mass_kg), velocity_m_s_(settings.tool_velocity_m_s) {
    scenario_.time.step_s = kStep_s;
    scenario_.world.gravity_m_s2 = Vec3::Zero();
    scenario_.bodies.resize(1);
    BodySettings& ball = scenario_.bodies[0];
    ball.name = "ball";
    ball.shape = SphereShape{};
    ball.model = BodyModel::elastic;
    ball.elastic.youngs_modulus_Pa = 10e3;
    ball.elastic.viscosity_Pa_s = 2;
    ball.elastic.friction = 0.5;
    if (settings.held) ball.fixed = {FixedRegion{.below_m = -0.02, .box = {}}};
    scenario_.tools.resize(1);
    scenario_.tools[0].name = "plate";
    scenario_.tools[0].shape = BoxShape{Vec3(0.1, 0.01, 0.1)};
    scenario_.tools[0].nodes.resolution = {16, 16};
    scenario_.tools[0].friction = 0.8;
    entry_ = {.name = "p", .pipeline = settings.pipeline};
    scene_ = buildScene(scenario_, entry_.usesNodes());
    simulation_ = makeElasticSimulation(scenario_, entry_, scene_,
                                        {{.position_m = Vec3(0, settings.tool_height_m, 0)}});
  }

  void step() {
    Pose pose = tool().pose;
    pose.position_m += kStep_s * velocity_m_s_;
    if (mass_kg_ > 0)
      simulation_->step({pose}, std::vector<double>{1 / mass_kg_});
    else
      simulation_->step({pose});
    velocity_m_s_ = tool().velocity_m_s;
  }

  const State& state() const { return simulation_->state(); }
  const VolumeState& volume() const { return *state().volume; }
  const ToolState& tool() const { return state().tools[0]; }
  const Vec3& velocity_m_s() const { return velocity_m_s_; }  ///< of the tool
  Vec3 momentum() const { return mass_kg_ * velocity_m_s_ + volume().momentum_kg_m_s; }
  double toolEnergy_J() const { return 0.5 * mass_kg_ * velocity_m_s_.squaredNorm(); }
  double energy_J() const {
    return toolEnergy_J() + volume().kinetic_J + volume().stored_J + volume().viscous_loss_J;
  }

 private:
  double mass_kg_;
  Vec3 velocity_m_s_;
  Scenario scenario_;
  PipelineSettings entry_;
  Scene scene_;
  std::unique_ptr<Simulation> simulation_;
};

class PushedBy : public testing::TestWithParam<PipelineKind> {};

std::string pipelineName(const testing::TestParamInfo<PipelineKind>& info) {
  return std::string(traitsOf(info.param).name);
}

TEST_P(PushedBy, WhatTissueGainsTheToolLoses) {
  World world({.pipeline = GetParam(), .tool_mass_kg = 0.05, .tool_velocity_m_s = Vec3(0.1, -0.5, 0)});
  for (int i = 0; i < 200; ++i) {
    const Vec3 before = world.momentum();
    world.step();
    ASSERT_LE((world.momentum() - before).norm(), 1e-13) << i;
  }
  EXPECT_GT(world.velocity_m_s().y(), -0.2) << "no contact, no test";
  EXPECT_LT(world.velocity_m_s().x(), 0.1) << "it rubs";
}

// The first step brings the pushed one to its speed, from rest by the substep.
TEST_P(PushedBy, OneOfEndlessMassIsLed) {
  World pushed({.pipeline = GetParam(), .tool_mass_kg = 1e15, .tool_velocity_m_s = Vec3(0, -0.2, 0)});
  pushed.step();
  World led({.pipeline = GetParam(),
             .tool_velocity_m_s = Vec3(0, -0.2, 0),
             .tool_height_m = pushed.tool().pose.position_m.y()});
  double reaction_N = 0;
  for (int i = 0; i < 50; ++i) {
    pushed.step();
    led.step();
    reaction_N = std::max(reaction_N, led.state().contact.reaction_on_tool_N.norm());
  }
  EXPECT_GT(reaction_N, 0.5) << "no contact, no test";
  for (std::size_t v = 0; v < led.state().positions_m.size(); ++v)
    ASSERT_LE((pushed.state().positions_m[v] - led.state().positions_m[v]).norm(), 1e-6) << v;
}

// Stored energy is half a substep behind, which is all that the sum may seem to grow by.
TEST_P(PushedBy, AToolThrownOnABallBouncesAndNoEnergyIsWon) {
  World world(
      {.pipeline = GetParam(), .tool_mass_kg = 0.2, .tool_velocity_m_s = Vec3(0, -0.3, 0), .held = true});
  world.step();
  const double first_J = world.energy_J();
  double most_J = first_J, least_of_tool_J = first_J;
  for (int i = 0; i < 300; ++i) {
    world.step();
    most_J = std::max(most_J, world.energy_J());
    least_of_tool_J = std::min(least_of_tool_J, world.toolEnergy_J());
  }
  EXPECT_LE(most_J, 1.001 * first_J);
  EXPECT_LT(least_of_tool_J, 0.01 * first_J) << "it came to rest";
  EXPECT_GT(world.velocity_m_s().y(), 0.1) << "and bounced";
  EXPECT_GT(world.energy_J(), 0.8 * first_J);
}

INSTANTIATE_TEST_SUITE_P(Elastic, PushedBy, testing::Values(PipelineKind::fukuhara, PipelineKind::swept),
                         pipelineName);

TEST(PushedTool, PrescribedPushesNone) {
  EXPECT_THROW(World({.pipeline = PipelineKind::prescribed, .tool_mass_kg = 1}).step(),
               std::invalid_argument);
}

}  // namespace
}  // namespace fissure::pushed_tool_test
