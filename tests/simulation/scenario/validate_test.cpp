#include "validate_changes.h"

namespace fissure::validate_test {

namespace {

TEST(Validate, TheFullScenarioIsGood) {
  const std::vector<Problem> problems = validate(full());
  EXPECT_TRUE(problems.empty()) << problems[0].path << " " << problems[0].message;
}

TEST(Validate, ScenarioAndTime) {
  expectProblems({
      {"format", [](Scenario& s) { s.format = 2; }},
      {"name", [](Scenario& s) { s.name = ""; }},
      {"name", [](Scenario& s) { s.name = "../x"; }},
      {"name", [](Scenario& s) { s.name = "caf\xc3\xa9"; }},
      {"name", [](Scenario& s) { s.name = std::string(65, 'x'); }},
      {"description", [](Scenario& s) { s.description = "two\nlines"; }},
      {"time.step_s", [](Scenario& s) { s.time.step_s = nan; }},
      {"time.settle_s", [](Scenario& s) { s.time.settle_s = -1; }},
      {"time.settle_s", [](Scenario& s) { s.time.settle_s = 1e6; }},
      {"time.settle_s", [](Scenario& s) { s.time.settle_s = nan; }},
      {"time.duration_s", [](Scenario& s) { s.time.duration_s = -1; }},
      {"time.duration_s", [](Scenario& s) { s.time.duration_s = nan; }},
      {"time.duration_s", [](Scenario& s) { s.time.duration_s = infinity; }},
      {"bodies", [](Scenario& s) { s.bodies.clear(); }},
      {"pipelines", [](Scenario& s) { s.pipelines.clear(); }},
  });
}

TEST(Validate, Expectations) {
  const auto expecting = [](const Expectation& expected) {
    return [expected](Scenario& s) { s.expect = {{.quantity = "steps", .min = 1}, expected}; };
  };
  expectProblems({
      {"expect.1.pipeline", expecting({.pipeline = "fukuhra", .quantity = "a", .max = 1})},
      {"expect.1.quantity", expecting({.quantity = "timing/mean_step_us", .max = 1})},
      {"expect.1.value", expecting({.quantity = "a", .value = nan, .tolerance = 1})},
      {"expect.1.tolerance", expecting({.quantity = "a", .value = 1, .tolerance = -1})},
      {"expect.1.max", expecting({.quantity = "a", .max = infinity})},
      {"expect.1", expecting({.quantity = "a", .value = 1})},
      {"expect.1", expecting({.quantity = "a", .tolerance = 1, .max = 1})},
      {"expect.1", expecting({.quantity = "a"})},
      {"expect.1.min", expecting({.quantity = "a", .min = 2, .max = 1})},
  });
  Scenario good = full();
  good.expect = {{.pipeline = "fukuhara", .quantity = "max_penetration_depth_m", .value = 1, .tolerance = 0}};
  EXPECT_TRUE(validate(good).empty());
}

TEST(Validate, World) {
  expectProblems({
      {"world.gravity_m_s2", [](Scenario& s) { s.world.gravity_m_s2.y() = nan; }},
      {"world.air_density_kg_m3", [](Scenario& s) { s.world.air_density_kg_m3 = -1; }},
      {"world.max_displacement_m", [](Scenario& s) { s.world.max_displacement_m = 0; }},
      {"ground.height_m", [](Scenario& s) { s.ground->height_m = infinity; }},
      {"ground.friction", [](Scenario& s) { s.ground->friction = -0.1; }},
      {"ground.hardness", [](Scenario& s) { s.ground->hardness = 1.1; }},
      {"measure.sample_spacing_m", [](Scenario& s) { s.measure.sample_spacing_m = 0; }},
  });
}

TEST(Validate, PipelinesForcesAndRecords) {
  expectProblems({
      {"pipelines.1.name", [](Scenario& s) { s.pipelines[1].name = "default"; }},
      {"pipelines.default.sdf_voxel_m", [](Scenario& s) { s.pipelines[0].sdf_voxel_m = 0; }},
      {"pipelines.default.kinematic_hardness", [](Scenario& s) { s.pipelines[0].kinematic_hardness = 2; }},
      {"pipelines.fukuhara.ray_length_m", [](Scenario& s) { s.pipelines[1].ray_length_m = -1; }},
      {"pipelines.fukuhara.sweeps", [](Scenario& s) { s.pipelines[1].sweeps = 0; }},
      {"pipelines.fukuhara.sweeps", [](Scenario& s) { s.pipelines[1].sweeps = 1001; }},
      {"pipelines.fukuhara.max_displacement_m", [](Scenario& s) { s.pipelines[1].max_displacement_m = 0; }},
      {"pipelines.fukuhara.time_limit_s", [](Scenario& s) { s.pipelines[1].time_limit_s = 0; }},
      {"force.hc.k", [](Scenario& s) { s.force[0].coefficients.k = -1; }},
      {"force.hc.lambda", [](Scenario& s) { s.force[0].coefficients.lambda = nan; }},
      {"force.hc.n", [](Scenario& s) { s.force[0].coefficients.n = 0; }},
      {"force.hc.c",
       [](Scenario& s) {
         s.force[0].model = ForceModel::kelvin_voigt;
         s.force[0].coefficients.c = -1;
       }},
      {"record.snapshots_every_s", [](Scenario& s) { s.record.snapshots_every_s = 0.0009; }},
      {"record.snapshots_every_s", [](Scenario& s) { s.record.snapshots_every_s = nan; }},
      {"record.force_inputs",
       [](Scenario& s) {
         s.record.force_inputs = true;
         s.force.clear();
       }},
      {"record.frames.every_s", [](Scenario& s) { s.record.frames->every_s = 0; }},
      {"record.frames.size_px", [](Scenario& s) { s.record.frames->width_px = 15; }},
      {"record.frames.size_px", [](Scenario& s) { s.record.frames->height_px = 4097; }},
      {"record.frames.camera.field_of_view_deg",
       [](Scenario& s) { s.record.frames->camera->field_of_view_deg = 0; }},
      {"record.frames.camera.look_at_m",
       [](Scenario& s) { s.record.frames->camera->look_at_m = s.record.frames->camera->position_m; }},
      {"record.frames.camera.up", [](Scenario& s) { s.record.frames->camera->up = Vec3::Zero(); }},
      {"record.frames.camera.up",
       [](Scenario& s) { s.record.frames->camera->up = -2 * s.record.frames->camera->position_m; }},
  });
}

TEST(Validate, RefusesAbsurdAmounts) {
  Scenario steps = smallest();
  steps.time.duration_s = 1e5;
  EXPECT_TRUE(validate(steps).empty());
  steps.time.duration_s = 1.01e5;
  ASSERT_EQ(validate(steps).size(), 1u);
  EXPECT_EQ(validate(steps)[0].path, "time.step_s");

  // So slow that the time is no double any more.
  Scenario slow = full();
  slow.tools.pop_back();
  segment(slow).speed_m_s = 1e-310;
  ASSERT_FALSE(validate(slow).empty());
  EXPECT_EQ(validate(slow)[0].path, "time.step_s");

  Scenario pictures = smallest();
  pictures.time.duration_s = 2000;
  pictures.record.frames = FrameSettings{0.001, 640, 480, {}};
  ASSERT_EQ(validate(pictures).size(), 1u);
  EXPECT_EQ(validate(pictures)[0].path, "record.frames.every_s");

  Scenario snapshots = smallest();
  sphere(snapshots).subdivisions = 7;
  snapshots.time.duration_s = 1000;
  snapshots.record.snapshots_every_s = 0.001;
  ASSERT_EQ(validate(snapshots).size(), 1u);
  EXPECT_EQ(validate(snapshots)[0].path, "record.snapshots_every_s");

  Scenario triangles = smallest();
  sphere(triangles).subdivisions = 7;
  for (int i = 0; i < 8; ++i) {
    triangles.bodies.push_back(triangles.bodies[0]);
    triangles.bodies.back().name += std::to_string(i);
  }
  ASSERT_EQ(validate(triangles).size(), 1u);
  EXPECT_EQ(validate(triangles)[0].path, "bodies");

  Scenario nodes = full();
  for (ToolSettings& tool : nodes.tools) tool.nodes.resolution = {512, 512};
  EXPECT_TRUE(validate(nodes).empty());
  for (int i = 0; i < 3; ++i) {
    nodes.tools.push_back(nodes.tools[0]);
    nodes.tools.back().name += std::to_string(i);
  }
  ASSERT_EQ(validate(nodes).size(), 1u);
  EXPECT_EQ(validate(nodes)[0].path, "tools");
}

// Friction is a share of a force, and contacts that only displace have none. The other pipelines have theirs.
TEST(Validate, FrictionNeedsAResponseThatHasAForce) {
  Scenario s = full();
  for (const PipelineTraits& pipeline : pipeline_table) {
    if (pipeline.kind == PipelineKind::raycast || pipeline.kind == PipelineKind::deformable) continue;
    s.pipelines = {{.name = "p", .pipeline = pipeline.kind}};
    s.tools[0].friction = 0.5;
    EXPECT_TRUE(validate(s).empty()) << pipeline.name;
  }
  for (const PipelineSettings& entry :
       {PipelineSettings{.name = "p", .pipeline = PipelineKind::raycast},
        PipelineSettings{
            .name = "p", .pipeline = PipelineKind::fukuhara, .response = ContactResponse::none}}) {
    s.pipelines = {entry};
    s.tools[0].friction = 0.5;
    ASSERT_EQ(validate(s).size(), 1u) << entry.traits().name;
    EXPECT_EQ(validate(s)[0].path, "tools.blade.friction");
    s.tools[0].friction = 0;
    EXPECT_TRUE(validate(s).empty()) << entry.traits().name;
  }
}

// Contacts that only displace leave the tissue the speed that it fell with.
TEST(Validate, TheHalfSpaceNeedsAResponseThatCarriesWeight) {
  Scenario s = smallest();
  for (const PipelineKind pipeline : {PipelineKind::raycast, PipelineKind::fukuhara}) {
    s.pipelines = {{.name = "p",
                    .pipeline = pipeline,
                    .response = ContactResponse::momentum,
                    .ground_contact = GroundKind::half_space}};
    EXPECT_TRUE(validate(s).empty());
    s.pipelines[0].response = ContactResponse::none;
    ASSERT_EQ(validate(s).size(), 1u);
    EXPECT_EQ(validate(s)[0].path, "pipelines.p.ground_contact");
  }
}

TEST(Validate, AFrameEveryStepIsFine) {
  Scenario s = smallest();
  s.time.step_s = 1.0 / 3;
  s.record.snapshots_every_s = 0.3333333333333333;
  s.record.frames = FrameSettings{0.33333333333333326, 640, 480, {}};  // one rounding below the step
  EXPECT_TRUE(validate(s).empty());
}

}  // namespace

}  // namespace fissure::validate_test
