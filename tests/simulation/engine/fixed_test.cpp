// Vertices that are fixed do not move, in no pipeline; the others do as if these were held by a hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/grid_nodes.h"
#include "engine/simulation.h"
#include "mesh/primitives.h"
#include "scene/fixed_vertices.h"
#include "scene/place.h"

namespace fissure::fixed_test {

namespace {

BodySettings sphere() {
  BodySettings body;
  body.name = "sphere";
  body.shape = SphereShape{};
  body.margin_m = 0.0005;
  body.material.linear_stiffness = 0.5;
  body.solver.pose_matching = 0.02;
  body.solver.damping = 0.01;
  body.solver.dynamic_friction = 0.5;
  body.solver.position_iterations = 10;
  return body;
}

Scene sceneOf(const Scenario& scenario) {
  Scene scene;
  for (const BodySettings& body : scenario.bodies) {
    scene.bodies.push_back({.name = body.name, .rest = placeBody(body), .first_vertex = scene.vertexCount()});
    scene.bodies.back().fixed_vertices = fixedVertices(body, scene.bodies.back().rest.vertices_m);
  }
  for (const ToolSettings& tool : scenario.tools) {
    scene.tools.push_back({.surface = makeSurface(tool.shape),
                           .box_size_m = std::get<BoxShape>(tool.shape).size_m,
                           .nodes = makeGridNodes(std::get<BoxShape>(tool.shape).size_m, {8, 8})});
  }
  return scene;
}

struct Case {
  const char* name;
  PipelineSettings entry;
  int velocity_iterations = 0;
};

void PrintTo(const Case& tested, std::ostream* stream) {
  *stream << tested.name;
}

class FixedVerticesIn : public testing::TestWithParam<Case> {};

// A plate comes down on a sphere whose lower half is fixed, and into that half.
TEST_P(FixedVerticesIn, DoNotMoveWhateverPressesOnThem) {
  Scenario scenario;
  scenario.bodies = {sphere()};
  scenario.bodies[0].fixed = {{.below_m = 0.001}};
  scenario.bodies[0].solver.velocity_iterations = GetParam().velocity_iterations;
  scenario.bodies[0].solver.drift_iterations = GetParam().velocity_iterations;
  scenario.tools.resize(1);
  scenario.tools[0].shape = BoxShape{Vec3(0.06, 0.01, 0.06)};
  scenario.ground = GroundSettings{.height_m = -0.028};  // higher than the lowest vertices
  const Scene scene = sceneOf(scenario);
  const std::vector<int>& fixed = scene.bodies[0].fixed_vertices;
  ASSERT_GT(fixed.size(), 30u);
  Pose pose{.position_m = Vec3(0.002, 0.036, 0)};
  auto simulation = makeSimulation(scenario, GetParam().entry, scene, {pose});
  const std::vector<Vec3> first_m = simulation->state().positions_m;
  double moved_m = 0;
  int contacts = 0;
  for (int i = 0; i < 120; ++i) {
    pose.position_m.y() -= 0.0003;
    simulation->step({pose});
    const State& state = simulation->state();
    contacts += state.contact.contact_count;
    for (const int vertex : fixed) {
      ASSERT_EQ(state.positions_m[vertex], first_m[vertex]) << "step " << i;
      ASSERT_EQ(state.velocities_m_s[vertex], Vec3::Zero()) << "step " << i;
      ASSERT_EQ(state.masses_kg[vertex], 0);
    }
    for (std::size_t v = 0; v < first_m.size(); ++v) {
      ASSERT_TRUE(state.positions_m[v].allFinite());
      moved_m = std::max(moved_m, (state.positions_m[v] - first_m[v]).norm());
    }
  }
  EXPECT_GT(contacts, 0);
  EXPECT_GT(moved_m, 0.001) << "the others do";
}

PipelineSettings entry(PipelineKind pipeline, SettingsPreset settings = SettingsPreset::stock) {
  return {.name = "p", .pipeline = pipeline, .settings = settings};
}

INSTANTIATE_TEST_SUITE_P(
    Pipelines, FixedVerticesIn,
    testing::Values(Case{"stock", entry(PipelineKind::default_sdf)},
                    Case{"tuned", entry(PipelineKind::default_sdf, SettingsPreset::tuned)},
                    Case{"velocity_solver", entry(PipelineKind::default_sdf, SettingsPreset::tuned), 5},
                    Case{"null", entry(PipelineKind::null_sdf)},
                    Case{"cluster", entry(PipelineKind::cluster, SettingsPreset::tuned)},
                    Case{"raycast", entry(PipelineKind::raycast)},
                    Case{"fukuhara", entry(PipelineKind::fukuhara)},
                    Case{"no_response",
                         {.name = "p",
                          .pipeline = PipelineKind::fukuhara,
                          .vertex_contacts = true,
                          .response = ContactResponse::none}},
                    Case{"prescribed", entry(PipelineKind::prescribed)}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// A sphere without ground or tool after five seconds of weight.
struct Hanging {
  std::vector<int> fixed;
  std::vector<Vec3> first_m, last_m;
  double speed_m_s = 0;  ///< of the fastest vertex
};

Hanging hang(const std::vector<FixedRegion>& regions, const Vec3& gravity_m_s2 = {0, -9.81, 0}) {
  Scenario scenario;
  scenario.world.gravity_m_s2 = gravity_m_s2;
  scenario.bodies = {sphere()};
  scenario.bodies[0].fixed = regions;
  const Scene scene = sceneOf(scenario);
  auto simulation = makeSimulation(scenario, entry(PipelineKind::fukuhara), scene, {});
  Hanging hanging{.fixed = scene.bodies[0].fixed_vertices, .first_m = simulation->state().positions_m};
  for (int i = 0; i < 5000; ++i) simulation->step({});
  hanging.last_m = simulation->state().positions_m;
  for (const Vec3& velocity : simulation->state().velocities_m_s)
    hanging.speed_m_s = std::max(hanging.speed_m_s, velocity.norm());
  return hanging;
}

double meanHeight_m(const std::vector<Vec3>& points_m) {
  double sum = 0;
  for (const Vec3& point : points_m) sum += point.y();
  return sum / static_cast<double>(points_m.size());
}

// Held at its top alone, or standing on its lowest cap, a body comes to rest: the fixed vertices carry all of
// its weight.
TEST(Fixed, TheyCarryTheWholeWeight) {
  for (const FixedRegion& region :
       {FixedRegion{.box = BoxRegion{Vec3(-1, 0.02, -1), Vec3(1, 1, 1)}}, FixedRegion{.below_m = -0.02}}) {
    const Hanging hanging = hang({region});
    EXPECT_GE(hanging.fixed.size(), 9u);
    EXPECT_LT(hanging.fixed.size(), 20u);
    EXPECT_LT(hanging.speed_m_s, 1e-6);
    const double sag_m = meanHeight_m(hanging.first_m) - meanHeight_m(hanging.last_m);
    EXPECT_GT(sag_m, 1e-7);
    EXPECT_LT(sag_m, 1e-4);
  }
  const Hanging falling = hang({});
  EXPECT_NEAR(falling.speed_m_s, 9.81 * 0.001 / 0.01, 0.02) << "as fast as damping lets it";
}

TEST(Fixed, WithoutWeightNothingMoves) {
  const Hanging floating = hang({{.below_m = -0.02}}, Vec3::Zero());
  for (std::size_t v = 0; v < floating.first_m.size(); ++v)
    EXPECT_NEAR((floating.last_m[v] - floating.first_m[v]).norm(), 0, 1e-9);
}

}  // namespace
}  // namespace fissure::fixed_test
