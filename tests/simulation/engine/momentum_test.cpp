// What the momentum response promises: weights are felt, bodies follow tools, and each step's momentum
// balances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "contact/grid_nodes.h"
#include "engine/simulation.h"
#include "mesh/primitives.h"
#include "scene/place.h"

namespace fissure::momentum_test {

namespace {

constexpr double kStep_s = 0.001;
constexpr double kMass_kg = 0.1;
constexpr double kWeight_N = 9.81 * kMass_kg;
constexpr double kMargin_m = 0.0005;

const GroundSettings kGround{.height_m = -0.03};  // below the sphere

/// A soft sphere of 30 mm and 100 g at the origin, not damped, and one box tool with 16 x 16 nodes a face.
class World {
 public:
  World(const Vec3& tool_size_m, const Vec3& tool_at_m, std::optional<GroundSettings> ground = {},
        ContactResponse response = ContactResponse::momentum, double damping = 0, double time_scale = 1,
        PipelineKind pipeline = PipelineKind::fukuhara) {
    scenario_.time.step_s = kStep_s;
    scenario_.ground = ground;
    BodySettings body;
    body.name = "sphere";
    body.shape = SphereShape{};
    body.mass_kg = kMass_kg;
    body.margin_m = kMargin_m;
    body.material.linear_stiffness = 0.5;
    body.solver.pose_matching = 0.02;
    body.solver.position_iterations = 10;
    body.solver.damping = damping;
    body.solver.time_scale = time_scale;
    body.solver.dynamic_friction = 0.5;
    scenario_.bodies = {body};
    scenario_.tools.resize(1);
    scenario_.tools[0].shape = BoxShape{tool_size_m};
    scene_.bodies.push_back({.name = body.name, .rest = placeBody(body)});
    scene_.tools.push_back({.name = "plate", .surface = makeBox(tool_size_m), .box_size_m = tool_size_m});
    const PipelineSettings entry{.name = "p", .pipeline = pipeline, .response = response};
    if (entry.usesNodes()) scene_.tools[0].nodes = makeGridNodes(tool_size_m, {16, 16});
    pose_.position_m = tool_at_m;
    simulation_ = makeSimulation(scenario_, entry, scene_, {pose_});
  }

  void step(const Vec3& tool_velocity_m_s = Vec3::Zero()) {
    pose_.position_m += kStep_s * tool_velocity_m_s;
    simulation_->step({pose_});
  }
  const State& state() const { return simulation_->state(); }
  double toolHeight_m() const { return pose_.position_m.y(); }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state().masses_kg.size(); ++i)
      sum += state().masses_kg[i] * state().velocities_m_s[i];
    return sum;
  }
  Vec3 velocity_m_s() const { return momentum() / kMass_kg; }
  double kineticEnergy_J() const {
    double sum = 0;
    for (std::size_t i = 0; i < state().masses_kg.size(); ++i)
      sum += 0.5 * state().masses_kg[i] * state().velocities_m_s[i].squaredNorm();
    return sum;
  }
  double lowest_m() const {
    double lowest = 1;
    for (const Vec3& p : state().positions_m) lowest = std::min(lowest, p.y());
    return lowest;
  }
  /// Mean reaction over `steps` with the tool at `velocity`.
  Vec3 meanReaction_N(int steps, const Vec3& velocity_m_s = Vec3::Zero()) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < steps; ++i) {
      step(velocity_m_s);
      sum += state().contact.reaction_on_tool_N;
    }
    return sum / steps;
  }

 private:
  Scenario scenario_;
  Scene scene_;
  Pose pose_;
  std::unique_ptr<Simulation> simulation_;
};

const Vec3 kTable_m(0.2, 0.01, 0.2);
const Vec3 kBelow_m(0, -0.03 - 0.005 - kMargin_m, 0);  // the table's upper face a margin below the sphere

std::string pipelineName(const testing::TestParamInfo<PipelineKind>& info) {
  return std::string(traitsOf(info.param).name);
}
const auto kPipelines = testing::Values(PipelineKind::fukuhara, PipelineKind::swept);

/// A method, and a body whose own time runs slower or faster than the scene's.
class TimeScale : public testing::TestWithParam<std::tuple<PipelineKind, double>> {
 protected:
  const PipelineKind pipeline = std::get<0>(GetParam());
  const double scale = std::get<1>(GetParam());
};

// The tissue's momentum changes in each step by gravity and by what the contacts report, to rounding (links
// and pose matching change none). They work on it for a step x scale of its own time.
TEST_P(TimeScale, EachStepsChangeIsGravityAndTheReactionInTheBodysOwnTime) {
  World world(kTable_m, kBelow_m, {}, ContactResponse::momentum, 0, scale, pipeline);
  double largest_N = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 before = world.momentum();
    world.step(Vec3(0, i < 200 ? 0.5 : 0, 0));  // hit from below, then let go
    const Vec3 reaction_N = world.state().contact.reaction_on_tool_N;
    const Vec3 expected = before + scale * kStep_s * (Vec3(0, -kWeight_N, 0) - reaction_N);
    ASSERT_NEAR((world.momentum() - expected).norm(), 0, 1e-13) << "step " << i;
    largest_N = std::max(largest_N, reaction_N.norm());
  }
  EXPECT_GT(largest_N, 2 * kWeight_N) << "no contact, no test";
}

TEST_P(TimeScale, ABodyAtRestOnAToolWeighsWhatItWeighs) {
  World world(kTable_m, kBelow_m, {}, ContactResponse::momentum, 0.01, scale, pipeline);
  for (int i = 0; i < 6000; ++i) world.step();
  EXPECT_NEAR(world.meanReaction_N(2000).y(), -kWeight_N, 0.01 * kWeight_N);
}
INSTANTIATE_TEST_SUITE_P(Scales, TimeScale, testing::Combine(kPipelines, testing::Values(0.5, 1.0, 2.0)));

/// What every method with momentum promises.
class MomentumOf : public testing::TestWithParam<PipelineKind> {
 protected:
  World world{kTable_m, kBelow_m, {}, ContactResponse::momentum, 0, 1, GetParam()};
};

TEST_P(MomentumOf, ABodyAtRestOnAToolWeighsWhatItWeighsAndDoesNotSink) {
  for (int i = 0; i < 2000; ++i) world.step();
  const double lowest_m = world.lowest_m();
  for (int i = 0; i < 7000; ++i) world.step();
  const Vec3 reaction_N = world.meanReaction_N(1000);
  EXPECT_NEAR(reaction_N.y(), -kWeight_N, 0.01 * kWeight_N);
  EXPECT_NEAR(std::hypot(reaction_N.x(), reaction_N.z()), 0, 0.01 * kWeight_N);
  EXPECT_NEAR(world.lowest_m(), lowest_m, kMargin_m);
  EXPECT_GT(world.lowest_m(), world.toolHeight_m() + 0.005) << "above the table";
}

// The same with response none: what it reports is no weight. (contact/METHOD.md 5)
TEST(Momentum, WithoutResponseTheReactionIsNoWeight) {
  World world(kTable_m, kBelow_m, {}, ContactResponse::none);
  for (int i = 0; i < 2000; ++i) world.step();
  EXPECT_GT(std::abs(world.meanReaction_N(1000).y()), 2 * kWeight_N);
}

TEST_P(MomentumOf, ALiftedBodyFollowsItsToolAndWeighsTheSame) {
  for (int i = 0; i < 1000; ++i) world.step();
  const Vec3 up(0, 0.1, 0);
  for (int i = 0; i < 1000; ++i) world.step(up);
  const double above_m = world.lowest_m() - world.toolHeight_m();
  EXPECT_NEAR(world.meanReaction_N(1000, up).y(), -kWeight_N, 0.01 * kWeight_N);
  EXPECT_NEAR(world.velocity_m_s().y(), 0.1, 0.002);
  EXPECT_NEAR(world.lowest_m() - world.toolHeight_m(), above_m, kMargin_m);
  for (int i = 0; i < 1000; ++i) world.step();
  EXPECT_NEAR(world.meanReaction_N(500).y(), -kWeight_N, 0.02 * kWeight_N) << "after the stop";
}
INSTANTIATE_TEST_SUITE_P(Pipelines, MomentumOf, kPipelines, pipelineName);

// Damped until nothing moves: the weight to a millionth.
TEST(Momentum, ARestingBodyWeighsItsWeightToAMillionthOnAllOfAToolsSurface) {
  World world(kTable_m, kBelow_m, {}, ContactResponse::momentum, 0.05, 1, PipelineKind::swept);
  for (int i = 0; i < 20000; ++i) world.step();
  EXPECT_NEAR(world.meanReaction_N(1000).y(), -kWeight_N, 1e-6 * kWeight_N);
}

// A blade pressed into the sphere on the ground and held there: the largest kinetic energy of the last tenth
// of a second, in joules.
double unrest_J(const GroundSettings& ground) {
  World world(Vec3(0.04, 0.002, 0.015), Vec3(0, 0.033, 0), ground, ContactResponse::momentum, 0.01);
  for (int i = 0; i < 210; ++i) world.step(Vec3(0, -0.1, 0));
  for (int i = 0; i < 300; ++i) world.step();
  double largest_J = 0;
  for (int i = 0; i < 100; ++i) {
    world.step();
    largest_J = std::max(largest_J, world.kineticEnergy_J());
  }
  EXPECT_GT(world.state().contact.reaction_on_tool_N.y(), 20) << "pressed";
  return largest_J;
}

TEST(Momentum, PressedTissueComesToRestOnTheDefaultGroundAndRattlesOnAHardOne) {
  const double rest_J = unrest_J(kGround);
  const double rattle_J = unrest_J({.height_m = -0.03, .hardness = 1});
  EXPECT_LT(rest_J, 1e-3);
  EXPECT_GT(rattle_J, 1e-2);
}

class PushedAtSpeed : public testing::TestWithParam<double> {};

// A wall pushes the sphere along frictionless ground: it takes the wall's speed, and is not thrown ahead of
// it.
TEST_P(PushedAtSpeed, ABodyTakesItsToolsSpeed) {
  const double speed_m_s = GetParam();
  World world(Vec3(0.01, 0.1, 0.4), Vec3(-0.04, 0, 0), kGround);
  for (int i = 0; i < 300; ++i) world.step();
  double fastest_m_s = 0, mean_m_s = 0;
  const int steps = 3000;
  for (int i = 0; i < steps; ++i) {
    world.step(Vec3(speed_m_s, 0, 0));
    fastest_m_s = std::max(fastest_m_s, world.velocity_m_s().x());
    if (i >= steps / 2) mean_m_s += world.velocity_m_s().x() / (steps - steps / 2);
  }
  EXPECT_LT(fastest_m_s, 2.05 * speed_m_s) << "an elastic ball leaves a wall with at most twice its speed";
  EXPECT_GT(mean_m_s, 0.95 * speed_m_s);
}
INSTANTIATE_TEST_SUITE_P(Speeds, PushedAtSpeed, testing::Values(0.1, 1.0));

}  // namespace
}  // namespace fissure::momentum_test
