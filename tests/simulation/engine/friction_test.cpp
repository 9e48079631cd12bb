// Coulomb friction of tools through a whole world, against closed forms. contact/METHOD.md 6.1.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/grid_nodes.h"
#include "engine/simulation.h"
#include "mesh/primitives.h"
#include "scene/place.h"

namespace fissure::friction_test {

namespace {

constexpr double kStep_s = 0.001;
constexpr double kMass_kg = 0.1;
constexpr double kGravity_m_s2 = 9.81;
constexpr double kWeight_N = kGravity_m_s2 * kMass_kg;
constexpr double kMargin_m = 0.0005;

BodySettings soft(const decltype(BodySettings::shape)& shape) {
  BodySettings body;
  body.name = "body";
  body.shape = shape;
  body.mass_kg = kMass_kg;
  body.margin_m = kMargin_m;
  body.material.linear_stiffness = 0.5;
  body.solver.pose_matching = 0.02;
  body.solver.position_iterations = 10;
  body.solver.dynamic_friction = 0.5;
  return body;
}

ToolSettings plate(const Vec3& size_m, double mu) {
  ToolSettings tool;
  tool.shape = BoxShape{size_m};
  tool.nodes.resolution = {24, 16};
  tool.friction = mu / 0.5;
  return tool;
}

/// One body of 100 g, not damped, without ground, and box tools.
class World {
 public:
  World(const BodySettings& body, const std::vector<ToolSettings>& tools, const std::vector<Pose>& poses,
        PipelineKind pipeline)
      : poses_(poses) {
    const PipelineSettings entry{.name = "p", .pipeline = pipeline};
    scenario_.time.step_s = kStep_s;
    scenario_.bodies = {body};
    scenario_.tools = tools;
    scene_.bodies.push_back({.name = body.name, .rest = placeBody(body)});
    for (const ToolSettings& tool : tools) {
      scene_.tools.push_back(
          {.surface = makeSurface(tool.shape),
           .box_size_m = std::get<BoxShape>(tool.shape).size_m,
           .nodes = entry.usesNodes()
                        ? makeGridNodes(std::get<BoxShape>(tool.shape).size_m, tool.nodes.resolution)
                        : ToolNodes{},
           .first_node = scene_.nodeCount()});
    }
    simulation_ = makeSimulation(scenario_, entry, scene_, poses_);
  }

  /// Each tool moves at its velocity, and all turn about their own centres.
  void step(const std::vector<Vec3>& velocities_m_s = {}, const Vec3& turn_rad_s = Vec3::Zero()) {
    for (std::size_t t = 0; t < velocities_m_s.size(); ++t)
      poses_[t].position_m += kStep_s * velocities_m_s[t];
    const Quat turn(Eigen::AngleAxisd(kStep_s * turn_rad_s.norm(), turn_rad_s.stableNormalized()));
    if (turn_rad_s != Vec3::Zero()) {
      for (Pose& pose : poses_) pose.orientation = turn * pose.orientation;
    }
    simulation_->step(poses_);
  }
  const State& state() const { return simulation_->state(); }
  Vec3 velocity_m_s() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state().masses_kg.size(); ++i)
      sum += state().masses_kg[i] * state().velocities_m_s[i];
    return sum / kMass_kg;
  }
  Vec3 centre_m() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : state().positions_m) sum += p;
    return sum / static_cast<double>(state().positions_m.size());
  }

 private:
  Scenario scenario_;
  Scene scene_;
  std::vector<Pose> poses_;
  std::unique_ptr<Simulation> simulation_;
};

const Vec3 kBlock_m(0.04, 0.02, 0.04);
const Vec3 kPlate_m(0.4, 0.01, 0.2);
/// Of the plate's centre from the block's, when the block lies on it a margin apart.
const Vec3 kUnder_m(0, -0.01 - 0.005 - kMargin_m, 0);

const auto kPipelines = testing::Values(PipelineKind::fukuhara, PipelineKind::swept);

/// Coefficient between block and slope, and how far the slope is turned about the vertical: a cone holds
/// alike in every direction.
struct Slope {
  double mu, turned_rad;
};
class FrictionOnASlope : public testing::TestWithParam<std::tuple<Slope, PipelineKind>> {
 protected:
  const double mu = std::get<0>(GetParam()).mu;
  static constexpr double kTangent = 0.4;
  const Quat slope = Quat(Eigen::AngleAxisd(std::get<0>(GetParam()).turned_rad, Vec3::UnitY())) *
                     Quat(Eigen::AngleAxisd(std::atan(kTangent), Vec3::UnitZ()));
  const Vec3 down = -(slope * Vec3::UnitX());
};

// g (sin - mu cos) where mu is below the slope's tangent, nothing where it is above.
TEST_P(FrictionOnASlope, ABlockSlidesAsCoulombSays) {
  BodySettings block = soft(BoxShape{kBlock_m});
  block.orientation = slope;
  World world(block, {plate(kPlate_m, mu)}, {{slope * kUnder_m, slope}}, std::get<1>(GetParam()));
  for (int i = 0; i < 50; ++i) world.step();  // its shape settles
  const double speed_m_s = world.velocity_m_s().dot(down);
  const Vec3 at_m = world.centre_m();
  const int steps = 150;
  for (int i = 0; i < steps; ++i) world.step();
  const double time_s = steps * kStep_s;
  const double cosine = 1 / std::hypot(1, kTangent);
  const double expected_m_s2 = std::max(0.0, kGravity_m_s2 * cosine * (kTangent - mu));
  EXPECT_NEAR((world.velocity_m_s().dot(down) - speed_m_s) / time_s, expected_m_s2, 1e-4);
  const Vec3 way_m = world.centre_m() - at_m;
  EXPECT_NEAR(way_m.dot(down), speed_m_s * time_s + 0.5 * expected_m_s2 * time_s * (time_s + kStep_s), 2e-5);
  EXPECT_NEAR((way_m - way_m.dot(down) * down).norm(), 0, 2e-5);
  if (mu > kTangent) {
    EXPECT_NEAR(way_m.norm(), 0, 1e-8) << "sticks";
  }
}
INSTANTIATE_TEST_SUITE_P(Slopes, FrictionOnASlope,
                         testing::Combine(testing::Values(Slope{0, 0}, Slope{0.1, 0}, Slope{0.3, 0},
                                                          Slope{0.39, 0}, Slope{0.41, 0}, Slope{0.8, 0},
                                                          Slope{0.1, 0.6}, Slope{0.3, 2.5}, Slope{0.41, 0.6}),
                                          kPipelines));

/// Friction as each method has it.
class FrictionOf : public testing::TestWithParam<PipelineKind> {};

// A plate starts off below a block: mu g, until the block is as fast as the plate.
TEST_P(FrictionOf, ABlockIsDraggedAlong) {
  World world(soft(BoxShape{kBlock_m}), {plate(kPlate_m, 0.2)}, {{kUnder_m, Quat::Identity()}}, GetParam());
  for (int i = 0; i < 50; ++i) world.step();
  const Vec3 velocity_m_s(0.24, 0, -0.18);  // 0.3 m/s: after 153 ms of 1.96 m/s2
  for (int i = 0; i < 100; ++i) world.step({velocity_m_s});
  EXPECT_NEAR((world.velocity_m_s() - velocity_m_s.normalized() * 0.2 * kGravity_m_s2 * 0.1).norm(), 0, 1e-4);
  for (int i = 0; i < 100; ++i) world.step({velocity_m_s});
  EXPECT_NEAR((world.velocity_m_s() - velocity_m_s).norm(), 0, 1e-4);
}

// On a turntable at 2 rad/s, 50 mm from its axis: taken along, and held on its circle.
TEST_P(FrictionOf, ABlockRidesOnATurntable) {
  const Vec3 from_axis_m(0.05, 0, 0);
  World world(soft(BoxShape{kBlock_m}), {plate(kPlate_m, 0.3)}, {{kUnder_m - from_axis_m, Quat::Identity()}},
              GetParam());
  const auto angle = [&] {
    const Vec3 from_m = world.centre_m() + from_axis_m;
    return std::atan2(-from_m.z(), from_m.x());
  };
  for (int i = 0; i < 200; ++i) world.step({}, Vec3(0, 2, 0));
  const double angle_rad = angle();
  const double radius_m = (world.centre_m() + from_axis_m).norm();
  for (int i = 0; i < 500; ++i) world.step({}, Vec3(0, 2, 0));
  EXPECT_NEAR(angle() - angle_rad, 2 * 500 * kStep_s, 1e-4);
  EXPECT_NEAR((world.centre_m() + from_axis_m).norm(), radius_m, 1e-5);
}

/// A soft sphere between two jaws that have just squeezed it by 5 mm from either side.
World squeezed(double mu, PipelineKind pipeline) {
  const Vec3 jaw_m(0.01, 0.06, 0.06);
  World world(soft(SphereShape{}), {plate(jaw_m, mu), plate(jaw_m, mu)},
              {{Vec3(-0.0355, 0, 0), Quat::Identity()}, {Vec3(0.0355, 0, 0), Quat::Identity()}}, pipeline);
  for (int i = 0; i < 50; ++i) world.step({Vec3(0.1, 0, 0), Vec3(-0.1, 0, 0)});
  return world;
}

// A body lifted by two jaws with friction stays lifted (contact/METHOD.md 6.1).
TEST_P(FrictionOf, ABodyBetweenJawsIsLiftedAndStaysLifted) {
  World world = squeezed(0.5, GetParam());
  const double from_m = world.centre_m().y();
  const Vec3 up(0, 0.1, 0);
  for (int i = 0; i < 1000; ++i) world.step({up, up});
  for (int i = 0; i < 500; ++i) world.step();
  const Vec3 lifted_m = world.centre_m();
  EXPECT_NEAR(lifted_m.y() - from_m, 0.1, 0.0001);
  Vec3 reaction_N = Vec3::Zero();
  const int steps = 3000;
  for (int i = 0; i < steps; ++i) {
    world.step();
    reaction_N += world.state().contact.reaction_on_tool_N / steps;
  }
  EXPECT_NEAR((world.centre_m() - lifted_m).norm(), 0, 1e-6);
  EXPECT_NEAR((reaction_N - Vec3(0, -kWeight_N, 0)).norm(), 0, 0.01 * kWeight_N);
}

TEST_P(FrictionOf, WithoutItTheBodySlipsOut) {
  World world = squeezed(0, GetParam());
  for (int i = 0; i < 500; ++i) world.step();
  EXPECT_LT(world.centre_m().y(), -0.5);
}

// What the jaws push and rub is the tissue's momentum, also where they turn and shake it.
TEST_P(FrictionOf, EachStepsMomentumIsGravityAndTheReaction) {
  World world = squeezed(0.3, GetParam());
  double rubbed_N = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 before = kMass_kg * world.velocity_m_s();
    const double shake_m_s = 0.3 * std::sin(0.1 * i);
    world.step({Vec3(0, shake_m_s, 0), Vec3(0, shake_m_s, 0.5 * shake_m_s)}, Vec3(0.5, 0, 0));
    const Vec3 reaction_N = world.state().contact.reaction_on_tool_N;
    const Vec3 expected = before + kStep_s * (Vec3(0, -kWeight_N, 0) - reaction_N);
    ASSERT_NEAR((kMass_kg * world.velocity_m_s() - expected).norm(), 0, 1e-12) << "step " << i;
    rubbed_N = std::max(rubbed_N, std::abs(reaction_N.y()));
  }
  EXPECT_GT(rubbed_N, kWeight_N) << "no friction, no test";
}
INSTANTIATE_TEST_SUITE_P(Pipelines, FrictionOf, kPipelines);

}  // namespace
}  // namespace fissure::friction_test
