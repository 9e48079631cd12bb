// Soft bodies of Bullet's engine: their clusters, each other, the ground, and free fall.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

#include "press.h"
#include "scene/fixed_vertices.h"

namespace fissure::simulation_test {

namespace {

// The blade comes down onto the sphere: no contact before it is there, then some, and the vertices of its
// clusters collide.
TEST(SoftBodies, ClustersCollideWithTheBlade) {
  Press press(PipelineKind::cluster, SettingsPreset::stock);
  int contacts = 0, pushes = 0;
  for (int i = 0; i < 40; ++i) {
    const State& state = press.step();
    contacts += state.contact.contact_count;
    const auto colliding =
        std::count(state.contact.vertex_contact.begin(), state.contact.vertex_contact.end(), 1);
    EXPECT_EQ(colliding > 0, state.contact.contact_count > 0) << "step " << i;
    EXPECT_TRUE(std::isnan(state.contact.reaction_on_tool_N.y())) << "Bullet does not say it";
    if (state.forces[0].elastic_N > 0) {
      ++pushes;
      EXPECT_GT(state.forces[0].force_on_tool_N.y(), 0) << "tissue below pushes the blade up";
    }
  }
  EXPECT_GT(contacts, 0);
  EXPECT_GT(pushes, 0);
}

// A sphere falls from 5 mm above onto another that stands on the ground: it goes into it unless both are told
// to collide.
TEST(SoftBodies, SoftBodiesMeetAsAsked) {
  const auto gapAfterFall = [](SoftContact soft_contact) {
    Scenario scenario = press();
    scenario.tools.clear();
    scenario.bodies.push_back(scenario.bodies[0]);
    scenario.bodies[1].name = "upper";
    scenario.bodies[1].position_m.y() = 0.095;
    for (BodySettings& body : scenario.bodies) body.soft_contact = soft_contact;
    const PipelineSettings entry{.name = "default", .pipeline = PipelineKind::default_sdf};
    const Scene scene = sceneOf(scenario, false);
    auto simulation = makeSimulation(scenario, entry, scene, {});
    for (int i = 0; i < 120; ++i) simulation->step({});
    Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
    const std::vector<Vec3>& positions_m = simulation->state().positions_m;
    const std::size_t half = positions_m.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      lower += positions_m[i] / static_cast<double>(half);
      upper += positions_m[half + i] / static_cast<double>(half);
    }
    return upper.y() - lower.y();
  };
  EXPECT_LT(gapAfterFall(SoftContact::none), 0.02) << "nothing holds the upper one: through";
  EXPECT_GT(gapAfterFall(SoftContact::vertices), 0.03);
  EXPECT_GT(gapAfterFall(SoftContact::clusters), 0.03);
}

/// Two spheres in one mesh, 2 mm apart.
SurfaceShape twoShells() {
  TrianglesShape shape;
  for (const double x : {-0.031, 0.031}) {
    TriangleMesh sphere = makeSphere(0.03, 1);
    const int first = static_cast<int>(shape.vertices_m.size());
    for (const Vec3& vertex : sphere.vertices_m) shape.vertices_m.push_back(vertex + Vec3(x, 0, 0));
    for (const Face& face : sphere.faces)
      shape.faces.push_back({first + face[0], first + face[1], first + face[2]});
  }
  return shape;
}

// Bullet would look for ever for the neighbour that joins the pieces of the lower body: its two shells, or
// the fixed vertices whose neighbours are all fixed.
TEST(SoftBodies, BodiesInPiecesMeetOthers) {
  ::alarm(120);
  for (const bool shells : {true, false}) {
    Scenario scenario = press();
    scenario.tools.clear();
    scenario.bodies.push_back(scenario.bodies[0]);
    BodySettings &lower = scenario.bodies[0], &upper = scenario.bodies[1];
    if (shells)
      lower.shape = twoShells();
    else
      lower.fixed = {{.below_m = 0.03}};
    upper.name = "upper";
    upper.position_m.y() = 0.095;
    for (BodySettings& body : scenario.bodies) body.soft_contact = SoftContact::vertices;
    const PipelineSettings entry{.name = "default", .pipeline = PipelineKind::default_sdf};
    Scene scene = sceneOf(scenario, false);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      scene.bodies[b].fixed_vertices = fixedVertices(scenario.bodies[b], scene.bodies[b].rest.vertices_m);
    auto simulation = makeSimulation(scenario, entry, scene, {});
    for (int i = 0; i < 120; ++i) simulation->step({});
    double lowest_m = 1;
    const std::vector<Vec3>& positions_m = simulation->state().positions_m;
    for (std::size_t i = static_cast<std::size_t>(scene.bodies[1].first_vertex); i < positions_m.size(); ++i)
      lowest_m = std::min(lowest_m, positions_m[i].y());
    EXPECT_GT(lowest_m, 0.02) << (shells ? "two shells" : "fixed") << ": held from below";
  }
  ::alarm(0);
}

// Free fall for a body without ground or tool: v = g t, and Bullet's semi-implicit Euler y = -g dt^2 n (n +
// 1) / 2. Exact time step: Bullet's own float step would be off by 5e-8 relative, which this sees.
TEST(SoftBodies, FreeFallUsesTheExactTimeStep) {
  Scenario scenario = press();
  scenario.ground.reset();
  scenario.tools.clear();
  scenario.bodies[0].solver = {.position_iterations = 1};
  const PipelineSettings entry{.name = "default", .pipeline = PipelineKind::default_sdf};
  const Scene scene = sceneOf(scenario, false);
  auto simulation = makeSimulation(scenario, entry, scene, {});
  const int n = 200;
  for (int i = 0; i < n; ++i) simulation->step({});
  const double expected = -9.81 * 1e-6 * n * (n + 1) / 2;
  for (std::size_t i = 0; i < scene.bodies[0].rest.vertices_m.size(); ++i) {
    const Vec3 fallen = simulation->state().positions_m[i] - scene.bodies[0].rest.vertices_m[i];
    ASSERT_NEAR(fallen.y(), expected, 2e-11) << "of " << expected;
    ASSERT_NEAR(fallen.x(), 0, 1e-12);
  }
}

// A body at rest on the ground for a second: it stands on its margin, to a tenth of a millimetre plus sag,
// and does not sink.
TEST(SoftBodies, TheGroundHoldsTheBody) {
  Scenario scenario = press();
  scenario.tools.clear();
  const PipelineSettings entry{.name = "default", .pipeline = PipelineKind::default_sdf};
  const Scene scene = sceneOf(scenario, false);
  auto simulation = makeSimulation(scenario, entry, scene, {});
  for (int i = 0; i < 1000; ++i) simulation->step({});
  double lowest = 1;
  for (const Vec3& p : simulation->state().positions_m) lowest = std::min(lowest, p.y());
  EXPECT_GT(lowest, -0.001);
  EXPECT_LT(lowest, 0.001);
}

}  // namespace

}  // namespace fissure::simulation_test
