// Elastic bodies under contact: momentum and energy balance, forces that do not depend on the step, and
// methods that agree about them.
#include "explicit/elastic_simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "scene/build_scene.h"

namespace fissure::elastic_simulation_test {

namespace {

constexpr double kGravity_m_s2 = 9.81;

/// A ball of 30 mm around the origin, and a plate above it.
Scenario ballUnderPlate() {
  Scenario scenario;
  scenario.time.step_s = 0.001;
  scenario.world.gravity_m_s2 = Vec3::Zero();
  scenario.bodies.resize(1);
  BodySettings& ball = scenario.bodies[0];
  ball.name = "ball";
  ball.shape = SphereShape{};
  ball.model = BodyModel::elastic;
  ball.elastic.youngs_modulus_Pa = 10e3;
  ball.elastic.viscosity_Pa_s = 2;
  scenario.tools.resize(1);
  scenario.tools[0].name = "plate";
  scenario.tools[0].shape = BoxShape{Vec3(0.1, 0.01, 0.1)};
  scenario.tools[0].nodes.resolution = {16, 16};
  return scenario;
}

constexpr double kPlateOnBall_m = 0.03 + 0.005 + 0.0005;  ///< height of the plate a margin above the ball

/// A scenario in steps, with its one tool moved by hand.
class World {
 public:
  World(const Scenario& scenario, PipelineKind pipeline, double plate_m = kPlateOnBall_m)
      : scenario_(scenario), entry_{.name = "p", .pipeline = pipeline, .response = {}} {
    if (entry_.usesNodes()) entry_.response = ContactResponse::momentum;
    scene_ = buildScene(scenario_, entry_.usesNodes());
    pose_.position_m.y() = plate_m;
    simulation_ = makeElasticSimulation(scenario_, entry_, scene_, {pose_});
  }

  void step(const Vec3& plate_velocity_m_s = Vec3::Zero()) {
    pose_.position_m += scenario_.time.step_s * plate_velocity_m_s;
    simulation_->step({pose_});
  }
  /// Presses with a smooth start and end: `depth_m` in `duration_s`, then holds as long.
  void press(double depth_m, double duration_s) {
    const double step_s = scenario_.time.step_s, top_m = pose_.position_m.y();
    const int steps = static_cast<int>(std::lround(duration_s / step_s));
    for (int i = 1; i <= 2 * steps; ++i) {
      const double s = std::min(1.0, static_cast<double>(i) / steps);
      pose_.position_m.y() = top_m - depth_m * s * s * s * (10 - 15 * s + 6 * s * s);
      simulation_->step({pose_});
    }
  }
  const State& state() const { return simulation_->state(); }
  const VolumeState& volume() const { return *simulation_->state().volume; }
  double mass_kg() const {
    const TetrahedralMesh& mesh = scene_.bodies[0].volume->mesh;
    double volume_m3 = 0;
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
      const Vec3 ab = mesh.vertices_m[b] - mesh.vertices_m[a], ac = mesh.vertices_m[c] - mesh.vertices_m[a];
      volume_m3 += ab.cross(ac).dot(mesh.vertices_m[d] - mesh.vertices_m[a]) / 6;
    }
    return scenario_.bodies[0].elastic.density_kg_m3 * volume_m3;
  }

 private:
  Scenario scenario_;
  PipelineSettings entry_;
  Scene scene_;
  Pose pose_;
  std::unique_ptr<Simulation> simulation_;
};

/// The same held below.
Scenario heldBall() {
  Scenario scenario = ballUnderPlate();
  scenario.bodies[0].fixed = {FixedRegion{.below_m = -0.02, .box = {}}};
  return scenario;
}

std::string pipelineName(const testing::TestParamInfo<PipelineKind>& info) {
  return std::string(traitsOf(info.param).name);
}

class Methods : public testing::TestWithParam<PipelineKind> {};

TEST_P(Methods, EachStepsChangeOfMomentumIsWhatTheToolGave) {
  World world(ballUnderPlate(), GetParam());
  double largest_N = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 before = world.volume().momentum_kg_m_s;
    world.step(Vec3(0, i < 50 ? -0.2 : 0, 0));
    const Vec3 reaction_N = world.state().contact.reaction_on_tool_N;
    ASSERT_LE((world.volume().momentum_kg_m_s - before + 0.001 * reaction_N).norm(), 1e-13) << i;
    largest_N = std::max(largest_N, reaction_N.norm());
  }
  EXPECT_GT(largest_N, 0.5) << "no contact, no test";
}

TEST_P(Methods, TheHeldForceDoesNotDependOnTheStep) {
  double finest_N = 0;
  for (const double step_s : {0.00025, 0.001, 0.004}) {
    Scenario scenario = heldBall();
    scenario.time.step_s = step_s;
    World world(scenario, GetParam());
    world.press(0.006, 0.3);
    const double held_N = world.state().contact.reaction_on_tool_N.y();
    if (finest_N == 0) finest_N = held_N;
    EXPECT_GT(held_N, 0.3);
    EXPECT_NEAR(held_N, finest_N, 0.01 * finest_N) << step_s;
  }
}

TEST_P(Methods, TheEnergyThatTheToolDoesIsStoredOrLost) {
  World world(heldBall(), GetParam());
  world.press(0.006, 0.3);
  const VolumeState& end = world.volume();
  const double found_J = end.kinetic_J + end.stored_J + end.gravity_J + end.viscous_loss_J;
  EXPECT_GT(end.stored_J, 1e-4);
  EXPECT_NEAR(found_J, end.contact_work_J, 0.01 * end.contact_work_J);
}

INSTANTIATE_TEST_SUITE_P(Elastic, Methods,
                         testing::Values(PipelineKind::fukuhara, PipelineKind::swept,
                                         PipelineKind::prescribed),
                         pipelineName);

TEST(ElasticSimulation, SweptAndNodesGiveTheSameForce) {
  double forces_N[2] = {};
  for (const PipelineKind pipeline : {PipelineKind::fukuhara, PipelineKind::swept}) {
    World world(heldBall(), pipeline);
    world.press(0.006, 0.3);
    forces_N[pipeline == PipelineKind::swept] = world.state().contact.reaction_on_tool_N.y();
  }
  EXPECT_NEAR(forces_N[1], forces_N[0], 0.02 * forces_N[0]);
}

// On the ground, which is an obstacle of swept contact.
TEST(ElasticSimulation, ABallAtRestOnTheGroundWeighsWhatItWeighs) {
  Scenario scenario = ballUnderPlate();
  scenario.world.gravity_m_s2 = Vec3(0, -kGravity_m_s2, 0);
  scenario.bodies[0].elastic.mass_damping_1_s = 20;
  scenario.ground = GroundSettings{.height_m = -0.03};
  World world(scenario, PipelineKind::swept, 1);
  for (int i = 0; i < 3000; ++i) world.step();
  const double weight_N = kGravity_m_s2 * world.mass_kg();
  EXPECT_NEAR(world.state().contact.ground_reaction_N.value().y(), -weight_N, 1e-6 * weight_N);
}

// While it vibrates after the impact its elements stiffen and relax; substeps that followed them up and down
// gave it a seventh of its energy.
TEST(ElasticSimulation, ABallThatBouncesWithoutViscosityKeepsItsEnergy) {
  Scenario scenario = ballUnderPlate();
  scenario.bodies[0].shape = SphereShape{.radius_m = 0.03, .subdivisions = 3};
  scenario.bodies[0].elastic.viscosity_Pa_s = 0;
  scenario.world.gravity_m_s2 = Vec3(0, -kGravity_m_s2, 0);
  scenario.time.step_s = 0.0005;
  scenario.ground = GroundSettings{.height_m = -0.06};
  World world(scenario, PipelineKind::swept, 1);
  const double fall_J = kGravity_m_s2 * world.mass_kg() * 0.03;
  double start_J = 0, largest_J = 0, most_stored_J = 0;
  for (int i = 0; i < 600; ++i) {
    world.step();
    const VolumeState& at = world.volume();
    const double balance_J = at.kinetic_J + at.stored_J + at.gravity_J - at.contact_work_J;
    if (i == 0) start_J = balance_J;
    largest_J = std::max(largest_J, std::abs(balance_J - start_J));
    most_stored_J = std::max(most_stored_J, at.stored_J);
  }
  EXPECT_GT(most_stored_J, 0.5 * fall_J) << "no impact, no test";
  EXPECT_LE(largest_J, 0.01 * fall_J);
}

TEST(ElasticSimulation, TwoRunsAreEqualToTheLastBit) {
  World one(heldBall(), PipelineKind::swept), other(heldBall(), PipelineKind::swept);
  one.press(0.006, 0.05);
  other.press(0.006, 0.05);
  EXPECT_EQ(one.state().positions_m, other.state().positions_m);
  EXPECT_EQ(one.state().velocities_m_s, other.state().velocities_m_s);
}

TEST(ElasticSimulation, FixedVerticesStayWhereTheyAre) {
  const Scenario scenario = heldBall();
  const Scene scene = buildScene(scenario, false);
  World world(scenario, PipelineKind::swept);
  world.press(0.01, 0.1);
  ASSERT_FALSE(scene.bodies[0].fixed_vertices.empty());
  for (const int vertex : scene.bodies[0].fixed_vertices)
    EXPECT_EQ(world.state().positions_m[vertex], scene.bodies[0].rest.vertices_m[vertex]);
}

TEST(ElasticSimulation, BulletsOwnContactIsRefused) {
  EXPECT_THROW(World(heldBall(), PipelineKind::default_sdf), std::invalid_argument);
}

}  // namespace

}  // namespace fissure::elastic_simulation_test
