#include "engine/simulation.h"

#include <gtest/gtest.h>

#include <chrono>

#include "base/error.h"
#include "press.h"
#include "scenario/catalog.h"

namespace fissure::simulation_test {

namespace {

using Names = std::vector<std::string>;

Names namesOf(const std::vector<StageTime>& stages) {
  Names names;
  for (const StageTime& stage : stages) names.push_back(stage.name);
  return names;
}

TEST(Simulation, SaysHowLongItsStagesTookAndTheyFitIntoTheSteps) {
  for (const PipelineKind pipeline : {PipelineKind::default_sdf, PipelineKind::fukuhara}) {
    Press press(pipeline);
    press.run(1);
    const std::vector<StageTime> before = press.simulation().stageTimes();
    const auto start = std::chrono::steady_clock::now();
    press.run(20);
    const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::vector<StageTime> after = press.simulation().stageTimes();
    ASSERT_EQ(namesOf(after), namesOf(before)) << traitsOf(pipeline).name;
    double sum_s = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_GT(after[i].total_s, before[i].total_s) << traitsOf(pipeline).name << ' ' << after[i].name;
      sum_s += after[i].total_s - before[i].total_s;
    }
    EXPECT_LE(sum_s, wall_s) << traitsOf(pipeline).name << ": no time is booked twice";
  }
}

TEST(Simulation, StagesAreThoseOfThePipeline) {
  EXPECT_EQ(namesOf(Press(PipelineKind::default_sdf).simulation().stageTimes()),
            (Names{"predict", "detection", "solve", "force_laws"}));
  EXPECT_EQ(namesOf(Press(PipelineKind::fukuhara).simulation().stageTimes()),
            (Names{"predict", "detection", "solve", "rays", "association", "vertex_contacts", "displacement",
                   "report", "transfer", "force_laws"}));
}

TEST(Simulation, BuildsExactlyThePipelinesOfTheCatalog) {
  std::vector<PipelineKind> offered;
  for (const PipelineTraits& pipeline : pipeline_table) offered.push_back(pipeline.kind);
  EXPECT_EQ(enginePipelines(), offered);
  const PipelineSettings unknown{.name = "x", .pipeline = static_cast<PipelineKind>(pipeline_table.size())};
  const Scenario scenario = press();
  EXPECT_THROW(makeSimulation(scenario, unknown, sceneOf(scenario, false), {at(0)}), std::invalid_argument);
}

TEST(Simulation, EvaluatesEveryLawOfTheCatalog) {
  Scenario scenario = press();
  const PipelineSettings entry{.name = "p", .pipeline = PipelineKind::fukuhara};
  for (const ForceLawEntry& law : forceLaws()) {
    for (const DeformationKind kind : {DeformationKind::paper, DeformationKind::corotated}) {
      scenario.force = {{.name = "law", .model = *modelNamed(law.name), .deformation = kind}};
      auto simulation = makeSimulation(scenario, entry, sceneOf(scenario, true), {at(0.0615)});
      for (int i = 1; i <= 50; ++i) simulation->step({at(0.0615 - 0.0002 * i)});
      EXPECT_GT(simulation->state().forces[0].elastic_N, 0.1)
          << law.name << ", " << nameIn(catalog().deformations, kind);
    }
  }
}

// Two blades side by side, the second one 2 mm lower.
TEST(Simulation, TwoToolsFeelTheirPartsOfTheForce) {
  for (const PipelineKind pipeline : {PipelineKind::default_sdf, PipelineKind::fukuhara}) {
    Scenario scenario = press();
    std::get<SphereShape>(scenario.bodies[0].shape).subdivisions = 3;
    scenario.tools[0].shape = BoxShape{Vec3(0.015, 0.002, 0.03)};
    scenario.tools.push_back(scenario.tools[0]);
    scenario.tools[1].name = "second";
    scenario.force.push_back({.name = "linear", .model = ForceModel::linear_elastic});
    const PipelineSettings entry{.name = "p", .pipeline = pipeline, .settings = SettingsPreset::tuned};
    Scene scene = sceneOf(scenario, entry.usesNodes());
    scene.tools[1].first_node = scene.tools[0].nodes.size();
    const auto poses = [](int step) {
      const double y = 0.0615 - 0.0002 * step;
      return std::vector<Pose>{{.position_m = Vec3(-0.01, y, 0)}, {.position_m = Vec3(0.01, y - 0.002, 0)}};
    };
    auto simulation = makeSimulation(scenario, entry, scene, poses(0));
    for (int i = 1; i <= 60; ++i) simulation->step(poses(i));
    const State& state = simulation->state();
    ASSERT_EQ(state.tool_forces_N.size(), 4u);
    for (std::size_t law = 0; law < 2; ++law) {
      const Vec3& first_N = state.tool_forces_N[2 * law];
      const Vec3& second_N = state.tool_forces_N[2 * law + 1];
      EXPECT_GT(first_N.y(), 0.01) << traitsOf(pipeline).name;
      EXPECT_GT(second_N.y(), 0.01) << traitsOf(pipeline).name;
      // Bullet's own contacts do not say how far they displace and share alike.
      EXPECT_TRUE(second_N.y() > first_N.y() || pipeline == PipelineKind::default_sdf);
      EXPECT_LT((first_N + second_N - state.forces[law].force_on_tool_N).norm(), 1e-12)
          << traitsOf(pipeline).name;
    }
  }
}

TEST(Simulation, RunsBulletInDoublePrecision) {
  EXPECT_EQ(engineVersion(), "Bullet 3.24, double precision");
}

// The null test of the harness: a detector of ours that only delegates changes no bit of any vertex.
TEST(Simulation, ADelegatingDetectorEqualsTheDefaultBitForBit) {
  Press reference(PipelineKind::default_sdf), delegating(PipelineKind::null_sdf);
  int contacts = 0;
  for (int i = 0; i < 150; ++i) {
    const State& expected = reference.step();
    const State& state = delegating.step();
    contacts += expected.contact.contact_count;
    ASSERT_EQ(state.positions_m, expected.positions_m) << "step " << i;
    ASSERT_EQ(state.velocities_m_s, expected.velocities_m_s);
    ASSERT_EQ(state.contact.contact_count, expected.contact.contact_count);
    ASSERT_EQ(state.forces[0].force_on_tool_N, expected.forces[0].force_on_tool_N);
  }
  EXPECT_GT(contacts, 0) << "no contact, no test";
}

TEST(Simulation, TheSameRunTwiceIsTheSameBitForBit) {
  for (const PipelineTraits& pipeline : pipeline_table) {
    if (pipeline.detection == ContactDetection::volume) continue;  // no shell's: deformable_test.cpp
    const State first = Press(pipeline.kind).run(100);
    const State second = Press(pipeline.kind).run(100);
    for (std::size_t i = 0; i < first.positions_m.size(); ++i) {
      ASSERT_EQ(first.positions_m[i], second.positions_m[i]) << pipeline.name;
    }
  }
}

TEST(Simulation, ForcesOfTrianglesAreKeptForLawsOnly) {
  for (const bool laws : {false, true}) {
    Scenario scenario = press();
    if (!laws) scenario.force.clear();
    const PipelineSettings entry{.name = "p", .pipeline = PipelineKind::fukuhara};
    auto simulation = makeSimulation(scenario, entry, sceneOf(scenario, true), {at(0.0615)});
    for (int i = 1; i <= 50; ++i) simulation->step({at(0.0615 - 0.0002 * i)});
    const State& state = simulation->state();
    EXPECT_GT(state.contact.contact_count, 0);
    EXPECT_EQ(state.colliding_triangles.capacity() > 0, laws);
    EXPECT_EQ(state.triangle_forces_N.capacity() > 0, laws);
  }
}

TEST(Simulation, InputsOfForceLawsAreKeptOnRequestOnly) {
  for (const bool asked : {false, true}) {
    Scenario scenario = press();
    scenario.record.force_inputs = asked;
    const PipelineSettings entry{.name = "p", .pipeline = PipelineKind::fukuhara};
    auto simulation = makeSimulation(scenario, entry, sceneOf(scenario, true), {at(0.0615)});
    for (int i = 1; i <= 50; ++i) simulation->step({at(0.0615 - 0.0002 * i)});
    const State& state = simulation->state();
    ASSERT_FALSE(state.colliding_triangles.empty());
    EXPECT_EQ(state.law_inputs.size(),
              asked ? state.colliding_triangles.size() * scenario.force.size() : std::size_t{0});
    EXPECT_EQ(state.law_inputs.capacity() > 0, asked);
  }
}

// The settings must reach Bullet: stock and tuned differ as soon as the tool touches.
TEST(Simulation, StockAndTunedDiffer) {
  const State stock = Press(PipelineKind::default_sdf, SettingsPreset::stock).run(60);
  const State tuned = Press(PipelineKind::default_sdf, SettingsPreset::tuned).run(60);
  EXPECT_NE(stock.positions_m, tuned.positions_m);
}

// Without tools all pipelines are the same world: they differ in the tool's contact, in whose the ground is,
// and in nothing else.
TEST(Simulation, WithoutContactAllPipelinesAgreeBitForBit) {
  std::vector<Vec3> reference, on_ground, on_own_ground;
  std::vector<PipelineSettings> entries;
  for (const PipelineTraits& pipeline : pipeline_table)
    if (pipeline.detection != ContactDetection::volume)
      entries.push_back({.name = std::string(pipeline.name), .pipeline = pipeline.kind});
  entries.push_back({.name = "fukuhara on the half-space",
                     .pipeline = PipelineKind::fukuhara,
                     .ground_contact = GroundKind::half_space});
  for (const PipelineSettings& entry : entries) {
    for (const bool with_ground : {false, true}) {
      Scenario scenario = press();
      if (!with_ground) scenario.ground.reset();
      const Scene scene = sceneOf(scenario, entry.usesNodes());
      auto simulation = makeSimulation(scenario, entry, scene, {at(0.2)});
      for (int i = 0; i < 100; ++i) simulation->step({at(0.2)});
      std::vector<Vec3>& expected = !with_ground ? reference : entry.ownGround() ? on_own_ground : on_ground;
      if (expected.empty()) expected = simulation->state().positions_m;
      EXPECT_EQ(simulation->state().positions_m, expected) << entry.name;
    }
  }
  EXPECT_NE(on_ground, on_own_ground);
  EXPECT_NE(on_ground, reference);
}

// A box 10 mm thick lies in the sphere from the start, one face exactly in a ring of its vertices. The nodes
// push it free, at most 5 mm a step at a node, and vertices in the plane of the face are not held against
// them.
TEST(Simulation, AToolThatStartsInTissueThrowsNothing) {
  Scenario scenario = press();
  scenario.tools[0].shape = BoxShape{Vec3(0.04, 0.01, 0.015)};
  const Scene scene = sceneOf(scenario, true);
  std::vector<double> rings;
  for (const Vec3& vertex : scene.bodies[0].rest.vertices_m) rings.push_back(vertex.y());
  std::sort(rings.begin(), rings.end());
  const double ring_m = rings[rings.size() - 2];  // below the top
  std::vector<std::vector<Vec3>> ends;
  for (const bool vertex_contacts : {false, true}) {
    const PipelineSettings entry{
        .name = "p", .pipeline = PipelineKind::fukuhara, .vertex_contacts = vertex_contacts};
    const Pose pose = at(ring_m - 0.005);
    auto simulation = makeSimulation(scenario, entry, scene, {pose});
    std::vector<Vec3> before = simulation->state().positions_m;
    for (int i = 0; i < 20; ++i) {
      simulation->step({pose});
      const std::vector<Vec3>& now = simulation->state().positions_m;
      for (std::size_t v = 0; v < now.size(); ++v)
        ASSERT_LE((now[v] - before[v]).norm(), 0.01) << "step " << i << ", vertex " << v;
      before = now;
    }
    ends.push_back(before);
  }
  EXPECT_EQ(ends[0], ends[1]) << "until it is free, with its nodes alone";
}

TEST(Simulation, ToolVelocitiesAreTheMeanOverTheStep) {
  Press tuned(PipelineKind::fukuhara);
  const ToolState& tool = tuned.run(3).tools[0];
  EXPECT_NEAR((tool.velocity_m_s - Vec3(0, -0.2, 0)).norm(), 0, 1e-9);
  EXPECT_EQ(tool.angular_velocity_rad_s, Vec3::Zero());
  Pose turned = tool.pose;
  turned.orientation = Quat(Eigen::AngleAxisd(0.01, Vec3::UnitZ()));
  tuned.simulation().step({turned});
  EXPECT_NEAR((tool.angular_velocity_rad_s - Vec3(0, 0, 10)).norm(), 0, 1e-9);
}

// The paper's claim in one line each: on the same press Bullet's vertices pass the thin spatula, the node
// pairs hold it out.
TEST(Simulation, TheDefaultLetsTheSpatulaInAndTheFullMethodHolds) {
  const auto topUnderBlade = [](const State& state) {
    double top = -1;  // highest vertex below the blade's footprint, one tissue edge around it
    for (const Vec3& p : state.positions_m) {
      if (std::abs(p.x()) < 0.01 && std::abs(p.z()) < 0.003) top = std::max(top, p.y());
    }
    return top;
  };
  const double lower_face = 0.0615 - 0.0002 * 100 - 0.001;
  EXPECT_GT(topUnderBlade(Press(PipelineKind::default_sdf, SettingsPreset::stock).run(100)),
            lower_face + 0.005);
  const double held = topUnderBlade(Press(PipelineKind::fukuhara).run(100));
  EXPECT_GT(held, 0) << "tissue is still there, below the blade";
  EXPECT_LT(held, lower_face);
}

// The reference without contact detection: a vertex that the blade reaches stays where it met the blade.
/// The same blade as a box and as its triangles.
TEST(Simulation, BulletMeetsTheHullOfTrianglesAsItMeetsABox) {
  Scenario scenario = press();
  std::get<SphereShape>(scenario.bodies[0].shape).subdivisions = 3;
  scenario.tools[0].shape = BoxShape{Vec3(0.08, 0.005, 0.08)};
  const PipelineSettings entry{
      .name = "default", .pipeline = PipelineKind::default_sdf, .settings = SettingsPreset::tuned};
  const auto pressed = [&](const Scene& scene) {
    auto simulation = makeSimulation(scenario, entry, scene, {at(0.063)});
    for (int i = 1; i <= 60; ++i) simulation->step({at(0.063 - 0.0002 * i)});
    return simulation->state();
  };
  Scene scene = sceneOf(scenario, false);
  const State box = pressed(scene);
  scene.tools[0].box_size_m.reset();
  const State hull = pressed(scene);
  EXPECT_GT(box.contact.contact_count, 10);
  EXPECT_EQ(hull.contact.contact_count, box.contact.contact_count);
  for (std::size_t v = 0; v < box.positions_m.size(); ++v)
    EXPECT_LT((hull.positions_m[v] - box.positions_m[v]).norm(), 1e-4) << v;
  scene.tools[0].closed = false;
  EXPECT_THROW(pressed(scene), InputError);
  scene.tools[0].closed = true;
  scene.tools[0].surface.vertices_m[0] *= 0.5;
  EXPECT_THROW(pressed(scene), InputError) << "not convex any more";
}

TEST(Simulation, PrescribedVerticesMoveWithTheTool) {
  Press press(PipelineKind::prescribed);
  int top = 0;
  const State& first = press.step();
  for (std::size_t v = 0; v < first.positions_m.size(); ++v)
    if (first.positions_m[v].y() > first.positions_m[top].y()) top = static_cast<int>(v);
  const State& state = press.run(60);
  EXPECT_EQ(state.contact.vertex_contact[top], 1);
  EXPECT_NEAR(state.positions_m[top].y(), state.tools[0].pose.position_m.y() - 0.001 - 0.0005, 1e-12);
  EXPECT_GT(state.forces[0].elastic_N, 0);
}

// Bullet's velocity iterations take positions from velocities.
TEST(Simulation, PrescribedVerticesStayWithTheToolUnderVelocityIterations) {
  Scenario scenario = press();
  scenario.bodies[0].solver.velocity_iterations = 3;
  scenario.bodies[0].solver.drift_iterations = 4;
  const Scene scene = sceneOf(scenario, false);
  const auto simulation =
      makeSimulation(scenario, {.name = "p", .pipeline = PipelineKind::prescribed}, scene, {at(0.0615)});
  for (int i = 1; i <= 60; ++i) simulation->step({at(0.0615 - 0.0002 * i)});
  const State& state = simulation->state();
  int held = 0;
  for (std::size_t v = 0; v < state.positions_m.size(); ++v) {
    if (!state.contact.vertex_contact[v]) continue;
    ++held;
    EXPECT_NEAR(state.positions_m[v].y(), state.tools[0].pose.position_m.y() - 0.001 - 0.0005, 1e-12) << v;
  }
  EXPECT_GT(held, 0);
}

// A blade at rest on held tissue feels the elastic force alone: x' is zero, and nothing is clamped. (The
// engine's own velocities would say tens of m/s.)
TEST(Simulation, AtRestTheForceIsElastic) {
  Press held(PipelineKind::fukuhara);
  held.run(60);
  for (int i = 0; i < 300; ++i) held.simulation().step({at(0.0615 - 0.0002 * 60)});
  const ForceSample& force = held.simulation().state().forces[0];
  EXPECT_GT(force.elastic_N, 1);
  EXPECT_LT(std::abs(force.viscous_N), 0.02 * force.elastic_N);
  EXPECT_EQ(force.adhesion_clamped, 0);
}

}  // namespace
}  // namespace fissure::simulation_test
