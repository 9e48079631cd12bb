// The half-space of swept, and of nodes that ask for it, through a whole world: weights, closed forms of
// friction, momentum of each step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/grid_nodes.h"
#include "engine/simulation.h"
#include "mesh/primitives.h"
#include "scene/place.h"

namespace fissure::ground_test {

namespace {

constexpr double kStep_s = 0.001;
constexpr double kMass_kg = 0.1;
constexpr double kGravity_m_s2 = 9.81;
constexpr double kWeight_N = kGravity_m_s2 * kMass_kg;
constexpr double kBodyFriction = 0.5;

/// A soft body of 100 g on the ground, its lowest point at y = 0, and a plate that is out of the way until it
/// is moved.
class World {
 public:
  struct Settings {
    SurfaceShape shape = SphereShape{};
    double height_m = 0.03;  ///< of the body's origin
    double friction = 0;     ///< with the ground
    double slope = 0;        ///< horizontal gravity over the vertical
    double damping = 0;
    int velocity_iterations = 0;
    double time_scale = 1;
    PipelineKind pipeline = PipelineKind::swept;
    GroundKind ground_contact = GroundKind::half_space;
    bool ground = true;
    int rounds = 4;
    double plate_m = 0.08;  ///< its height at first
  };
  explicit World(const Settings& settings) {
    Scenario scenario;
    scenario.time.step_s = kStep_s;
    scenario.world.gravity_m_s2 = Vec3(settings.slope * kGravity_m_s2, -kGravity_m_s2, 0);
    if (settings.ground) scenario.ground = GroundSettings{.friction = settings.friction / kBodyFriction};
    BodySettings body;
    body.name = "body";
    body.shape = settings.shape;
    body.position_m.y() = settings.height_m;
    body.mass_kg = kMass_kg;
    body.material.linear_stiffness = 0.5;
    body.solver.pose_matching = 0.02;
    body.solver.position_iterations = 10;
    body.solver.damping = settings.damping;
    body.solver.velocity_iterations = settings.velocity_iterations;
    body.solver.time_scale = settings.time_scale;
    body.solver.dynamic_friction = kBodyFriction;
    scenario.bodies = {body};
    const Vec3 size_m(0.2, 0.01, 0.2);
    scenario.tools.resize(1);
    scenario.tools[0].shape = BoxShape{size_m};
    scenario.tools[0].friction = settings.friction / kBodyFriction;
    scene_.bodies.push_back({.name = body.name, .rest = placeBody(body)});
    scene_.tools.push_back({.name = "plate", .surface = makeBox(size_m), .box_size_m = size_m});
    const PipelineSettings entry{.name = "p",
                                 .pipeline = settings.pipeline,
                                 .response = ContactResponse::momentum,
                                 .ground_contact = settings.ground_contact,
                                 .rounds = settings.rounds};
    if (entry.usesNodes()) scene_.tools[0].nodes = makeGridNodes(size_m, {16, 16});
    pose_.position_m.y() = settings.plate_m;
    simulation_ = makeSimulation(scenario, entry, scene_, {pose_});
  }
  void step(const Vec3& plates_velocity_m_s = Vec3::Zero()) {
    pose_.position_m += kStep_s * plates_velocity_m_s;
    simulation_->step({pose_});
  }
  const State& state() const { return simulation_->state(); }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state().masses_kg.size(); ++i)
      sum += state().masses_kg[i] * state().velocities_m_s[i];
    return sum;
  }
  Vec3 velocity_m_s() const { return momentum() / kMass_kg; }
  Vec3 centre_m() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : state().positions_m) sum += p;
    return sum / static_cast<double>(state().positions_m.size());
  }
  double lowest_m() const {
    double lowest_m = 1;
    for (const Vec3& p : state().positions_m) lowest_m = std::min(lowest_m, p.y());
    return lowest_m;
  }
  Vec3 onGround_N() const { return state().contact.ground_reaction_N.value(); }
  double counter(const std::string& name) const {
    for (const SummaryValue& value : simulation_->counters())
      if (value.name == name) return static_cast<double>(std::get<long long>(value.value));
    return -1;
  }

 private:
  Scene scene_;
  Pose pose_;
  std::unique_ptr<Simulation> simulation_;
};

const auto kPipelines = testing::Values(PipelineKind::swept, PipelineKind::fukuhara);

const BoxShape kBlock{Vec3(0.04, 0.02, 0.04)};

TEST(Ground, ARestingBodyWeighsItsWeightToAMillionth) {
  for (const SurfaceShape& shape : {SurfaceShape(kBlock), SurfaceShape(SphereShape{})}) {
    const bool is_block = std::holds_alternative<BoxShape>(shape);
    World world({.shape = shape, .height_m = is_block ? 0.01 : 0.03, .friction = 0.25, .damping = 0.05});
    for (int i = 0; i < 20000; ++i) world.step();
    Vec3 mean_N = Vec3::Zero();
    for (int i = 0; i < 1000; ++i) {
      world.step();
      mean_N += world.onGround_N() / 1000;
    }
    EXPECT_NEAR(mean_N.y(), -kWeight_N, 1e-6 * kWeight_N) << is_block;
    EXPECT_NEAR(world.lowest_m(), 0, 1e-9);
    EXPECT_EQ(world.state().contact.reaction_on_tool_N, Vec3::Zero());
    EXPECT_EQ(world.state().contact.contact_count, 0);
  }
}

TEST(Ground, ARestingBodyWeighsItsWeightOnThatOfNodesToo) {
  World world({.shape = kBlock, .height_m = 0.01, .damping = 0.5, .pipeline = PipelineKind::fukuhara});
  for (int i = 0; i < 1500; ++i) world.step();
  EXPECT_NEAR(world.onGround_N().y(), -kWeight_N, 1e-6 * kWeight_N);
  EXPECT_NEAR(world.lowest_m(), 0, 1e-9);
  EXPECT_EQ(world.state().contact.contact_count, 0);
}

// Bullet's velocity iterations put positions anew from velocities: the ground it is shown must be in both.
TEST(Ground, ARestingBodyWeighsItsWeightWithVelocityIterationsToo) {
  World world({.shape = kBlock, .height_m = 0.01, .damping = 0.5, .velocity_iterations = 1});
  for (int i = 0; i < 3000; ++i) world.step();
  EXPECT_NEAR(world.onGround_N().y(), -kWeight_N, 1e-6 * kWeight_N);
}

class GroundTimeScale : public testing::TestWithParam<std::tuple<PipelineKind, double>> {};

// Gravity, the plate and the ground are all that changes momentum, also where they rub.
TEST_P(GroundTimeScale, EachStepsChangeIsGravityAndBothReactions) {
  const auto [pipeline, scale] = GetParam();
  World world({.friction = 0.3, .time_scale = scale, .pipeline = pipeline});
  double tool_N = 0, ground_N = 0, rubbed_N = 0;
  for (int i = 0; i < 600; ++i) {
    const Vec3 before = world.momentum();
    world.step(i < 300 ? Vec3(0, -0.1, 0) : Vec3(0.1, i < 400 ? 0 : 0.2, 0));
    const Vec3 on_tool_N = world.state().contact.reaction_on_tool_N;
    const Vec3 expected =
        before + scale * kStep_s * (Vec3(0, -kWeight_N, 0) - on_tool_N - world.onGround_N());
    ASSERT_NEAR((world.momentum() - expected).norm(), 0, 1e-13) << "step " << i;
    ASSERT_GE(world.lowest_m(), -1e-9) << "step " << i;
    tool_N = std::max(tool_N, on_tool_N.norm());
    ground_N = std::max(ground_N, -world.onGround_N().y());
    rubbed_N = std::max(rubbed_N, std::abs(world.onGround_N().x()));
  }
  EXPECT_GT(tool_N, 5 * kWeight_N);
  EXPECT_GT(ground_N, 5 * kWeight_N);
  EXPECT_GT(rubbed_N, 0.1 * kWeight_N);
}
INSTANTIATE_TEST_SUITE_P(Scales, GroundTimeScale,
                         testing::Combine(kPipelines, testing::Values(0.5, 1.0, 2.0)));

class GroundSlope : public testing::TestWithParam<std::tuple<PipelineKind, double>> {};

// A block pulled sideways by 0.4 of its weight: g (0.4 - mu) where mu is below 0.4, nothing where it is
// above.
TEST_P(GroundSlope, ABlockSlipsAsCoulombSays) {
  const auto [pipeline, mu] = GetParam();
  const double pulled = 0.4;
  World world({.shape = kBlock, .height_m = 0.01, .friction = mu, .slope = pulled, .pipeline = pipeline});
  for (int i = 0; i < 50; ++i) world.step();  // its shape settles
  const Vec3 from_m_s = world.velocity_m_s(), from_m = world.centre_m();
  double largest = 0;
  for (int i = 0; i < 150; ++i) {
    world.step();
    const Vec3 on_ground_N = world.onGround_N();
    largest = std::max(largest, std::hypot(on_ground_N.x(), on_ground_N.z()) / -on_ground_N.y());
  }
  const double expected_m_s2 = kGravity_m_s2 * std::max(pulled - mu, 0.0);
  EXPECT_NEAR((world.velocity_m_s() - from_m_s).x() / 0.15, expected_m_s2, 1e-4);
  EXPECT_LE(largest, mu + 1e-9);
  if (mu > pulled) {
    EXPECT_NEAR((world.centre_m() - from_m).norm(), 0, 1e-8) << "sticks";
  }
}
INSTANTIATE_TEST_SUITE_P(Coefficients, GroundSlope,
                         testing::Combine(kPipelines, testing::Values(0, 0.1, 0.3, 0.39, 0.41, 0.8)));

class GroundByRounds : public testing::TestWithParam<int> {};

// Dropped from 50 mm and pressed flat at 2 m/s, no vertex is ever below: by impulses, and by truncation
// alone.
TEST_P(GroundByRounds, ADroppedAndFlattenedBodyDoesNotSink) {
  World world({.height_m = 0.08, .friction = 0.25, .rounds = GetParam(), .plate_m = 0.2});
  double fastest_m_s = 0;
  for (int i = 0; i < 400; ++i) {
    world.step();
    ASSERT_GE(world.lowest_m(), -1e-9) << "step " << i;
    fastest_m_s = std::max(fastest_m_s, -world.velocity_m_s().y());
  }
  EXPECT_NEAR(fastest_m_s, std::sqrt(2 * kGravity_m_s2 * 0.05), 0.02) << "dropped";
  for (int i = 0; i < 95; ++i) {  // down to 5 mm above the ground
    world.step(Vec3(0, -2, 0));
    ASSERT_GE(world.lowest_m(), -1e-9) << "pressed, step " << i;
  }
  EXPECT_EQ(world.counter("no_room_steps"), 0);
}
INSTANTIATE_TEST_SUITE_P(Rounds, GroundByRounds, testing::Values(0, 1, 4));

// As scenarios place it, its lowest point on the ground, a body is neither lifted nor thrown.
TEST(Ground, ABodyLaidOnItIsNotKicked) {
  World world({.shape = kBlock, .height_m = 0.01, .friction = 0.25});
  const double from_m = world.centre_m().y();
  double fastest_m_s = 0;
  for (int i = 0; i < 100; ++i) {
    world.step();
    fastest_m_s = std::max(fastest_m_s, world.velocity_m_s().y());
    ASSERT_EQ(world.lowest_m(), 0) << "step " << i;
  }
  EXPECT_LT(fastest_m_s, 0.01);
  EXPECT_NEAR(world.centre_m().y(), from_m, 0.0002) << "sags, and is not lifted";
}

// A node pushes on a triangle where it meets it, which takes the nearest vertex farther than the node went.
// Those had been beyond the reach of the ground.
TEST(Ground, NodesPressNothingBelowIt) {
  for (int i = 0; i < 10; ++i) {
    World world({.friction = 0.25, .pipeline = PipelineKind::raycast, .plate_m = 0.067 + 0.0005 * i});
    for (int step = 0; step < 6; ++step) {
      world.step(Vec3(0, -10, 0));
      EXPECT_GE(world.lowest_m(), -1e-9) << "plate " << i << ", step " << step;
    }
    EXPECT_GT(-world.onGround_N().y(), 100 * kWeight_N);
  }
}

TEST(Ground, OnlyOnesOwnSaysWhatItBears) {
  World without({.ground = false});
  without.step();
  EXPECT_FALSE(without.state().contact.ground_reaction_N);
  for (const PipelineKind pipeline : {PipelineKind::default_sdf, PipelineKind::fukuhara}) {
    World bullets({.pipeline = pipeline, .ground_contact = GroundKind::bullet});
    bullets.step();
    EXPECT_FALSE(bullets.state().contact.ground_reaction_N);
  }
}

}  // namespace
}  // namespace fissure::ground_test
