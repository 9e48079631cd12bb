#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "scenario_text.h"
#include "text/scalars.h"

namespace fissure::write_test {

namespace {

/// A scenario in which every field has a value that is not its default; equality with what is read back then
/// says that no field is forgotten.
const char* const every_field =
    "format: 1\n"
    "name: every-field_1\n"
    "description: \"Quotes \\\", backslash \\\\, hash # and colon: ü\"\n"
    "time: {step_s: 0.0013, settle_s: 0.1, duration_s: 0.7}\n"
    "world: {gravity_m_s2: [0.1, -1.62, 1e-9], air_density_kg_m3: 1.3, max_displacement_m: 12.5}\n"
    "ground: {height_m: -0.25, friction: 0.7, hardness: 0.9}\n"
    "bodies:\n"
    "  - name: ball\n"
    "    shape: {type: sphere, radius_m: 0.031, subdivisions: 1}\n"
    "    position_m: [1, 2, 3]\n"
    "    orientation: [0.5, 0.5, 0.5, 0.5]\n"
    "    mass_kg: 0.3333333333333333\n"
    "    mass_from_faces: true\n"
    "    margin_m: 0.0007\n"
    "    bending_distance: 3\n"
    "    randomize_links: false\n"
    "    pose_volume: false\n"
    "    pose_frame: false\n"
    "    soft_contact: vertices\n"
    "    fixed: [{below_m: -0.01}, {box: {min_m: [0, 1, 2], max_m: [3, 4, 5]}}]\n"
    "    material: {linear_stiffness: 0.1, angular_stiffness: 0.2, volume_stiffness: 0.3}\n"
    "    solver: {velocity_correction: 0.9, damping: 0.1, drag: 0.2, lift: 0.3, pressure: -4,\n"
    "             volume_conservation: 0.5, dynamic_friction: 0.6, pose_matching: 0.7, rigid_hardness: 0.8,\n"
    "             soft_hardness: 0.85, anchor_hardness: 0.95, max_volume: 1.1, time_scale: 1.2,\n"
    "             velocity_iterations: 1, position_iterations: 2, drift_iterations: 3, aero_model: "
    "F_OneSided}\n"
    "    clusters: {count: 7, iterations: 8, rigid_hardness: 0.11, kinematic_hardness: 0.12,\n"
    "               soft_hardness: 0.13, rigid_split: 0.14, kinematic_split: 0.15, soft_split: 0.16,\n"
    "               node_damping: 0.17, linear_damping: 0.18, angular_damping: 0.19, matching: 0.2}\n"
    "    gauges: [{name: top, box: {min_m: [-1, 1, 2], max_m: [3, 4, 5]}}]\n"
    "  - {name: cube, shape: {type: box, size_m: [0.1, 0.2, 0.3], cells: [3, 4, 5]}}\n"
    "  - name: tetrahedron\n"
    "    shape:\n"
    "      type: triangles\n"
    "      vertices_m: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
    "      faces: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]\n"
    "  - {name: lobes, shape: {type: lobes, size_m: [0.1, 0.2, 0.3], slit_depth_m: 0.12, slit_width_m: 0.01, "
    "edge_m: 0.07}}\n"
    "tools:\n"
    "  - name: blade\n"
    "    shape: {type: box, size_m: [0.05, 0.003, 0.016]}\n"
    "    nodes: {resolution: [9, 5], narrow_rows: 4}\n"
    "    friction: 0.15\n"
    "    force_limit_N: 7.5\n"
    "    coupling: {mass_kg: 0.06, stiffness_N_m: 2900, damping_N_s_m: 19, force: hc}\n"
    "    motion:\n"
    "      type: script\n"
    "      start_m: [0.1, 0.2, 0.3]\n"
    "      start_orientation: [0.6, 0, 0, 0.8]\n"
    "      segments:\n"
    "        - {move_to_m: [0, 0, 1], speed_m_s: 0.2, timing: minimum_jerk}\n"
    "        - {rotate_to: [0, 0.6, 0, 0.8], duration_s: 0.3, timing: trapezoidal, ramp_fraction: 0.4}\n"
    "        - {move_to_m: [1, 0, 1], rotate_to: [0, 0, 0, 1], duration_s: 0.5}\n"
    "        - {hold_s: 0.125}\n"
    "  - name: hand\n"
    "    shape: {type: box, size_m: [1, 1, 1]}\n"
    "    motion:\n"
    "      type: replay\n"
    "      file: my log (1).csv\n"
    "      time_column: \"t [s]\"\n"
    "      position_columns: [px, py, pz]\n"
    "      position_unit: mm\n"
    "      quaternion_columns: [\"1\", \"true\", \"null\", \"-w\"]\n"
    "      mapping: {axes: [z, x, y], scale: 2.5, origin_device_m: [1, 2, 3], origin_scene_m: [4, 5, 6],\n"
    "                mount: [0, 1, 0, 0]}\n"
    "      start_s: 0.5\n"
    "      end_s: 9.5\n"
    "      interpolation: monotone_cubic\n"
    "      max_gap_s: 0.1\n"
    "      jump_m: 0.01\n"
    "      jump_speed_m_s: 3\n"
    "      time_unit: us\n"
    "      where: {column: State, equals: \"1\"}\n"
    "  - name: hand3\n"
    "    shape: {type: box, size_m: [1, 1, 1]}\n"
    "    motion: {type: replay, file: my log (1).csv, rate_hz: 60, frame_column: Frame}\n"
    "  - name: hand2\n"
    "    shape: {type: box, size_m: [1, 1, 1]}\n"
    "    motion: {type: replay, file: my log (1).csv, layout: axes, rate_hz: 999.5, mapping: {frame: "
    "chai3d}}\n"
    "pipelines:\n"
    "  - {name: a, pipeline: default, settings: tuned, sdf_voxel_m: 0.002, kinematic_hardness: 0.3, "
    "time_limit_s: 9}\n"
    "  - {pipeline: \"null\", precision: f32}\n"
    "  - {name: b, pipeline: raycast, ray_length_m: 0.06, vertex_contacts: true, response: momentum, "
    "ground_contact: half_space, sweeps: 11, "
    "max_displacement_m: 0.02, precision: "
    "f64}\n"
    "  - {name: c, pipeline: swept, sweeps: 12, max_displacement_m: 0.03, rounds: 7}\n"
    "force:\n"
    "  - {name: hc, model: hunt_crossley, tissue: meat_4, k: 201, lambda: 51, n: 1.4, rate: velocities}\n"
    "  - {model: linear_elastic, k: 202}\n"
    "  - {model: kelvin_voigt, k: 203, c: 3, rate: velocities, deformation: corotated, per_area: true}\n"
    "record:\n"
    "  snapshots_every_s: 0.02\n"
    "  frames:\n"
    "    every_s: 0.04\n"
    "    size_px: [320, 240]\n"
    "    camera: {position_m: [1, 1, 1], look_at_m: [0, 1, 0], up: [0, 0, 1], field_of_view_deg: 50}\n"
    "  force_inputs: true\n"
    "measure: {sample_spacing_m: 0.0004, certify: true}\n"
    "expect:\n"
    "  - {quantity: max_penetration_depth_m, pipeline: b, value: 0.1, tolerance: 0.01, min: 0.05, max: "
    "0.2}\n";

class RoundTrip : public ScenarioFiles {};

TEST_F(RoundTrip, EveryFieldIsReadAndWrittenBack) {
  write("my log (1).csv", "t\n0\n");
  const std::filesystem::path file = write("every.yaml", every_field);
  const LoadedScenario loaded = loadScenario(file);
  const LoadedScenario again = parseScenario(loaded.resolved, file);
  EXPECT_EQ(again.scenario, loaded.scenario) << loaded.resolved;
  EXPECT_EQ(again.resolved, loaded.resolved);
}

TEST_F(RoundTrip, EveryFieldReachesItsPlace) {
  write("my log (1).csv", "t\n0\n");
  const Scenario s = loadScenario(write("every.yaml", every_field)).scenario;
  EXPECT_EQ(s.description, "Quotes \", backslash \\, hash # and colon: \xc3\xbc");
  EXPECT_EQ(s.time, (TimeSettings{0.0013, 0.1, 0.7}));
  EXPECT_EQ(s.world, (WorldSettings{{0.1, -1.62, 1e-9}, 1.3, 12.5}));
  EXPECT_EQ(s.ground, (GroundSettings{-0.25, 0.7, 0.9}));
  const BodySettings& ball = s.bodies[0];
  EXPECT_EQ(ball.material, (MaterialSettings{0.1, 0.2, 0.3}));
  EXPECT_EQ(ball.solver, (SolverSettings{0.9, 0.1, 0.2, 0.3, -4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.95, 1.1, 1.2, 1,
                                         2, 3, AeroModel::F_OneSided}));
  EXPECT_EQ(ball, (BodySettings{"ball",
                                SphereShape{0.031, 1},
                                {1, 2, 3},
                                {0.5, 0.5, 0.5, 0.5},
                                0.3333333333333333,
                                true,
                                0.0007,
                                3,
                                false,
                                false,
                                false,
                                SoftContact::vertices,
                                ball.fixed,
                                ball.material,
                                ball.solver,
                                ball.clusters,
                                {{"top", BoxRegion{{-1, 1, 2}, {3, 4, 5}}}}}));
  EXPECT_EQ(ball.clusters,
            (ClusterSettings{7, 8, 0.11, 0.12, 0.13, 0.14, 0.15, 0.16, 0.17, 0.18, 0.19, 0.2}));
  EXPECT_EQ(std::get<BoxShape>(s.bodies[1].shape), (BoxShape{{0.1, 0.2, 0.3}, {3, 4, 5}}));
  const auto& triangles = std::get<TrianglesShape>(s.bodies[2].shape);
  EXPECT_EQ(triangles.vertices_m[3], Vec3(0, 0, 1));
  EXPECT_EQ(triangles.faces[3], (Face{1, 2, 3}));
  EXPECT_EQ(std::get<LobesShape>(s.bodies[3].shape), (LobesShape{{0.1, 0.2, 0.3}, 0.12, 0.01, 0.07}));
  EXPECT_EQ(s.pipelines[0], (PipelineSettings{.name = "a",
                                              .pipeline = PipelineKind::default_sdf,
                                              .settings = SettingsPreset::tuned,
                                              .sdf_voxel_m = 0.002,
                                              .kinematic_hardness = 0.3,
                                              .time_limit_s = 9}));
  EXPECT_EQ(s.pipelines[1].name, "null");
  EXPECT_EQ(s.pipelines[1].precision, Precision::f32);
  EXPECT_EQ(s.pipelines[2], (PipelineSettings{.name = "b",
                                              .pipeline = PipelineKind::raycast,
                                              .ray_length_m = 0.06,
                                              .vertex_contacts = true,
                                              .response = ContactResponse::momentum,
                                              .ground_contact = GroundKind::half_space,
                                              .sweeps = 11,
                                              .max_displacement_m = 0.02}));
  EXPECT_EQ(s.pipelines[3], (PipelineSettings{.name = "c",
                                              .pipeline = PipelineKind::swept,
                                              .sweeps = 12,
                                              .max_displacement_m = 0.03,
                                              .rounds = 7}));
  EXPECT_EQ(s.force,
            (std::vector<ForceSettings>{
                {.name = "hc",
                 .model = ForceModel::hunt_crossley,
                 .coefficients = {.k = 201, .lambda = 51, .n = 1.4},
                 .rate = RateSource::velocities,
                 .tissue = "meat_4"},
                {.name = "linear_elastic", .model = ForceModel::linear_elastic, .coefficients = {.k = 202}},
                {.name = "kelvin_voigt",
                 .model = ForceModel::kelvin_voigt,
                 .coefficients = {.k = 203, .c = 3},
                 .rate = RateSource::velocities,
                 .deformation = DeformationKind::corotated,
                 .per_area = true}}));
  const CameraSettings camera{{1, 1, 1}, {0, 1, 0}, {0, 0, 1}, 50};
  EXPECT_EQ(s.record, (RecordSettings{0.02, FrameSettings{0.04, 320, 240, camera}, true}));
  EXPECT_EQ(s.measure, (MeasureSettings{.sample_spacing_m = 0.0004, .certify = true}));
  EXPECT_EQ(s.tools[0].force_limit_N, 7.5);
  EXPECT_EQ(s.tools[1].force_limit_N, std::nullopt);
  EXPECT_EQ(s.tools[0].coupling, (CouplingSettings{0.06, 2900, 19, "hc"}));
  EXPECT_EQ(s.tools[1].coupling, std::nullopt);
}

TEST_F(RoundTrip, MotionsReachTheirPlace) {
  write("my log (1).csv", "t\n0\n");
  const Scenario s = loadScenario(write("every.yaml", every_field)).scenario;
  ASSERT_EQ(s.tools.size(), 4u);
  EXPECT_EQ(s.tools[0].nodes.resolution, (std::array<int, 2>{9, 5}));
  EXPECT_EQ(s.tools[0].nodes.narrow_rows, 4);
  EXPECT_EQ(s.tools[0].friction, 0.15);
  EXPECT_EQ(s.bodies[0].fixed,
            (std::vector<FixedRegion>{{-0.01, {}}, {{}, BoxRegion{{0, 1, 2}, {3, 4, 5}}}}));
  const auto& script = std::get<ScriptMotion>(s.tools[0].motion);
  EXPECT_EQ(script.start_orientation, Quat(0.8, 0.6, 0, 0));  // Eigen's order: w, x, y, z
  ASSERT_EQ(script.segments.size(), 4u);
  EXPECT_EQ(script.segments[0], (MotionSegment{Vec3(0, 0, 1), {}, {}, 0.2, {}, Timing::minimum_jerk, 0.25}));
  EXPECT_EQ(script.segments[1],
            (MotionSegment{{}, Quat(0.8, 0, 0.6, 0), {}, {}, 0.3, Timing::trapezoidal, 0.4}));
  EXPECT_EQ(script.segments[3], (MotionSegment{{}, {}, 0.125, {}, {}, Timing::constant, 0.25}));
  ReplayMotion replay;
  replay.file = "my log (1).csv";
  replay.time_column = "t [s]";
  replay.position_columns = {"px", "py", "pz"};
  replay.position_unit = LengthUnit::mm;
  replay.quaternion_columns = {"1", "true", "null", "-w"};
  replay.mapping = {{"z", "x", "y"}, 2.5, {1, 2, 3}, {4, 5, 6}, Quat(0, 0, 1, 0)};
  replay.start_s = 0.5;
  replay.end_s = 9.5;
  replay.interpolation = Interpolation::monotone_cubic;
  replay.max_gap_s = 0.1;
  replay.jump_m = 0.01;
  replay.jump_speed_m_s = 3;
  replay.time_unit = TimeUnit::us;
  replay.where = RowFilter{"State", "1"};
  EXPECT_EQ(std::get<ReplayMotion>(s.tools[1].motion), replay);
  ReplayMotion raw;
  raw.file = "my log (1).csv";
  raw.layout = LogLayout::axes;
  raw.rate_hz = 999.5;
  raw.mapping.frame = DeviceFrame::chai3d;
  EXPECT_EQ(std::get<ReplayMotion>(s.tools[3].motion), raw);
  ReplayMotion counted;
  counted.file = "my log (1).csv";
  counted.rate_hz = 60;
  counted.frame_column = "Frame";
  EXPECT_EQ(std::get<ReplayMotion>(s.tools[2].motion), counted);
}

TEST(Write, WritesEveryDefaultAndLeavesOutWhatHasNoValue) {
  const std::string text = toYaml(smallest());
  for (const char* part :
       {"description: \"\"\n", "settle_s: 0\n", "  gravity_m_s2: [0, -9.81, 0]\n", "tools: []\n",
        "  - name: default\n    pipeline: default\n", "    sdf_voxel_m: 0.25\n",
        "    kinematic_hardness: 0.1\n", "record:\n  force_inputs: false\n", "    margin_m: 5e-04\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
  }
  for (const char* part : {"ground", "frames", "snapshots", "sample_spacing", "sweeps", "vertex_contacts"}) {
    EXPECT_EQ(text.find(part), std::string::npos) << part << text;
  }
}

TEST(Write, DoublesComeBackBitForBit) {
  Scenario s = smallest();
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, 123456789.0, 1e22, 1e-7, -0.0}) {
    s.world.gravity_m_s2 = {value, -value, value};
    const Scenario again = parseScenario(toYaml(s), "smallest.yaml").scenario;
    EXPECT_EQ(again.world.gravity_m_s2, s.world.gravity_m_s2);
    EXPECT_EQ(std::signbit(again.world.gravity_m_s2.x()), std::signbit(value));
  }
}

TEST(Write, QuaternionsAreNormalisedOnceAndThenStay) {
  // Off unit length by 4e-7, as a file with seven digits is.
  Scenario s = parseScenario(smallest_text, "a.yaml",
                             {{"bodies.0.orientation", "[0.1825742, 0.3651484, 0.5477226, 0.7302967]"}})
                   .scenario;
  EXPECT_NEAR(s.bodies[0].orientation.norm(), 1, 4e-16);
  EXPECT_NEAR(s.bodies[0].orientation.w(), 0.7302967, 1e-6);
  for (int i = 0; i < 3; ++i) {
    const Scenario again = parseScenario(toYaml(s), "a.yaml").scenario;
    EXPECT_EQ(again, s);
    s = again;
  }
}

TEST(Stored, AScenarioThatCannotBeReadIsRefusedWithTheNameOfTheFileThatHoldsIt) {
  const std::string text = toYaml(smallest());
  EXPECT_EQ(parseStoredScenario(text, "a.h5").resolved, text);
  EXPECT_EQ(inputError([&] {
              parseStoredScenario(text + "colour: red\n", "a.h5");
            }).rfind("a.h5: its scenario cannot be read: scenario_resolved:", 0),
            0u);
}

TEST(Configs, EachOneLoadsAndRoundTripsAndSaysWhatItStresses) {
  for (const char* folder : {"/configs", "/configs/fixtures"}) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(FISSURE_SOURCE_DIR + std::string(folder))) {
      if (entry.path().extension() != ".yaml") continue;
      const LoadedScenario loaded = loadScenario(entry.path());
      EXPECT_EQ(parseScenario(loaded.resolved, entry.path()).scenario, loaded.scenario) << entry.path();
      EXPECT_EQ(loaded.scenario.name, entry.path().stem());
      EXPECT_EQ(loaded.source.substr(0, 11), "# Stresses ") << entry.path();
      ++count;
    }
    EXPECT_GE(count, 20) << folder;
  }
}

TEST(Configs, EveryFixtureIsCertifiedAndNamesTheMethod) {
  for (const auto& entry : std::filesystem::directory_iterator(FISSURE_SOURCE_DIR "/configs/fixtures")) {
    if (entry.path().extension() != ".yaml") continue;
    const Scenario scenario = loadScenario(entry.path()).scenario;
    EXPECT_TRUE(scenario.measure.certify) << entry.path();
    EXPECT_EQ(scenario.tools.size(), 1u) << entry.path();
    EXPECT_TRUE(std::any_of(scenario.pipelines.begin(), scenario.pipelines.end(),
                            [](const PipelineSettings& pipeline) { return pipeline.name == "fukuhara"; }))
        << entry.path();
  }
}

/// contact/METHOD.md 1: the tool's lower face starts 6 mm above the sphere's top and ends 25 mm below it.
void expectPressedFrom6To25mm(const Scenario& s) {
  const double radius_m = std::get<SphereShape>(s.bodies.at(0).shape).radius_m;
  const double top_m = s.bodies[0].position_m.y() + radius_m;
  const double half_thickness_m = std::get<BoxShape>(s.tools.at(0).shape).size_m.y() / 2;
  const auto& motion = std::get<ScriptMotion>(s.tools[0].motion);
  EXPECT_NEAR(motion.start_m.y() - half_thickness_m - top_m, 0.006, 1e-12);
  EXPECT_NEAR(top_m - (motion.segments.at(0).move_to_m.value().y() - half_thickness_m), 0.025, 1e-12);
  EXPECT_EQ(motion.segments[0].speed_m_s, 0.1);
  EXPECT_EQ(s.ground.value().height_m, s.bodies[0].position_m.y() - radius_m);
}

TEST(Configs, SpatulaPressIsThePapersFirstScene) {
  const Scenario s = loadScenario(FISSURE_SOURCE_DIR "/configs/spatula_press.yaml").scenario;
  expectPressedFrom6To25mm(s);
  std::vector<std::string> names;
  for (const PipelineSettings& pipeline : s.pipelines) names.push_back(pipeline.name);
  EXPECT_EQ(names, (std::vector<std::string>{"default", "default_tuned", "raycast", "fukuhara", "swept"}));
}

TEST(Configs, PlatePressIsThePlateOnTheFinerSphere) {
  const Scenario s = loadScenario(FISSURE_SOURCE_DIR "/configs/plate_press.yaml").scenario;
  expectPressedFrom6To25mm(s);
  EXPECT_EQ(std::get<SphereShape>(s.bodies[0].shape).subdivisions, 3);
  EXPECT_EQ(s.tools[0].nodes.resolution, (std::array<int, 2>{16, 16}));
}

}  // namespace

}  // namespace fissure::write_test
