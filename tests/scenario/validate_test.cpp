#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "scenario_text.h"

namespace fissure {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A good scenario with one of everything: a ball, a scripted blade, a replayed hand, two pipelines, a law, a
/// camera.
Scenario full() {
  Scenario s = smallest();
  s.ground = GroundSettings{};
  s.time.duration_s.reset();
  ToolSettings blade;
  blade.name = "blade";
  MotionSegment down;
  down.move_to_m = Vec3(0, -1, 0);
  down.speed_m_s = 2;
  blade.motion = ScriptMotion{Vec3::Zero(), Quat::Identity(), {down}};
  ToolSettings hand;
  hand.name = "hand";
  ReplayMotion replay;
  replay.file = "hand.csv";
  replay.time_column = "t";
  hand.motion = replay;
  s.tools = {blade, hand};
  PipelineSettings fukuhara;
  fukuhara.name = fukuhara.pipeline = "fukuhara";
  s.pipelines.push_back(fukuhara);
  s.force = {{"hc", "hunt_crossley", 200, 50, 1.3}};
  s.record.snapshots_every_s = 0.01;
  s.record.frames = FrameSettings{};
  s.record.frames->camera = CameraSettings{};
  return s;
}

ScriptMotion& script(Scenario& s) {
  return std::get<ScriptMotion>(s.tools[0].motion);
}
MotionSegment& segment(Scenario& s) {
  return script(s).segments[0];
}
ReplayMotion& replay(Scenario& s) {
  return std::get<ReplayMotion>(s.tools[1].motion);
}
SphereShape& sphere(Scenario& s) {
  return std::get<SphereShape>(s.bodies[0].shape);
}

struct Change {
  const char* path;  ///< of the one problem that this makes
  std::function<void(Scenario&)> make;
};

void expectProblems(const std::vector<Change>& changes) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scenario s = full();
    changes[i].make(s);
    const std::vector<Problem> problems = validate(s);
    ASSERT_FALSE(problems.empty()) << "change " << i << " at " << changes[i].path;
    EXPECT_EQ(problems[0].path, changes[i].path) << "change " << i << ": " << problems[0].message;
    const std::string& message = problems[0].message;
    EXPECT_TRUE(message.find("expected") != std::string::npos ||
                message.find("did you mean") != std::string::npos)
        << message;
    EXPECT_EQ(problems.size(), 1u) << "change " << i << ": " << problems.back().path;
  }
}

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

TEST(Validate, ALogOfAxesNeedsARateAlone) {
  Scenario s = full();
  replay(s).layout = LogLayout::axes;
  replay(s).time_column.reset();
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_NE(validate(s)[0].message.find("expected rate_hz"), std::string::npos);
  replay(s).rate_hz = 100;
  EXPECT_TRUE(validate(s).empty());
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

TEST(Validate, Bodies) {
  expectProblems({
      {"bodies.0.name", [](Scenario& s) { s.bodies[0].name = "a.b"; }},
      {"bodies.1.name", [](Scenario& s) { s.bodies.push_back(s.bodies[0]); }},
      {"bodies.ball.shape.radius_m", [](Scenario& s) { sphere(s).radius_m = 0; }},
      {"bodies.ball.shape.radius_m", [](Scenario& s) { sphere(s).radius_m = nan; }},
      {"bodies.ball.shape.subdivisions", [](Scenario& s) { sphere(s).subdivisions = -1; }},
      {"bodies.ball.shape.subdivisions", [](Scenario& s) { sphere(s).subdivisions = 8; }},
      {"bodies.ball.shape.size_m",
       [](Scenario& s) {
         s.bodies[0].shape = BoxShape{{1, 0, 1}};
       }},
      {"bodies.ball.position_m", [](Scenario& s) { s.bodies[0].position_m.z() = nan; }},
      {"bodies.ball.orientation", [](Scenario& s) { s.bodies[0].orientation.w() = 1.1; }},
      {"bodies.ball.orientation", [](Scenario& s) { s.bodies[0].orientation.x() = nan; }},
      {"bodies.ball.mass_kg", [](Scenario& s) { s.bodies[0].mass_kg = 0; }},
      {"bodies.ball.margin_m", [](Scenario& s) { s.bodies[0].margin_m = -0.001; }},
      {"bodies.ball.bending_distance", [](Scenario& s) { s.bodies[0].bending_distance = 1; }},
      {"bodies.ball.bending_distance", [](Scenario& s) { s.bodies[0].bending_distance = 6; }},
      {"bodies.ball.bending_distance", [](Scenario& s) { s.bodies[0].bending_distance = -2; }},
      {"bodies.ball.material.linear_stiffness",
       [](Scenario& s) { s.bodies[0].material.linear_stiffness = 2; }},
      {"bodies.ball.material.angular_stiffness",
       [](Scenario& s) { s.bodies[0].material.angular_stiffness = -1; }},
      {"bodies.ball.material.volume_stiffness",
       [](Scenario& s) { s.bodies[0].material.volume_stiffness = nan; }},
  });
}

TEST(Validate, SolverSettings) {
  const auto solver = [](auto field, auto value) {
    return [=](Scenario& s) { s.bodies[0].solver.*field = value; };
  };
  using S = SolverSettings;
  expectProblems({
      {"bodies.ball.solver.velocity_correction", solver(&S::velocity_correction, -1.0)},
      {"bodies.ball.solver.damping", solver(&S::damping, 1.5)},
      {"bodies.ball.solver.drag", solver(&S::drag, -1.0)},
      {"bodies.ball.solver.lift", solver(&S::lift, nan)},
      {"bodies.ball.solver.pressure", solver(&S::pressure, infinity)},
      {"bodies.ball.solver.volume_conservation", solver(&S::volume_conservation, -1.0)},
      {"bodies.ball.solver.dynamic_friction", solver(&S::dynamic_friction, 1.5)},
      {"bodies.ball.solver.pose_matching", solver(&S::pose_matching, -0.5)},
      {"bodies.ball.solver.rigid_hardness", solver(&S::rigid_hardness, 1.5)},
      {"bodies.ball.solver.soft_hardness", solver(&S::soft_hardness, 1.5)},
      {"bodies.ball.solver.anchor_hardness", solver(&S::anchor_hardness, 1.5)},
      {"bodies.ball.solver.max_volume", solver(&S::max_volume, 0.0)},
      {"bodies.ball.solver.time_scale", solver(&S::time_scale, 0.0)},
      {"bodies.ball.solver.velocity_iterations", solver(&S::velocity_iterations, -1)},
      {"bodies.ball.solver.position_iterations", solver(&S::position_iterations, 0)},
      {"bodies.ball.solver.drift_iterations", solver(&S::drift_iterations, 1001)},
  });
}

TEST(Validate, ClusterSettingsAndSoftContact) {
  const auto clusters = [](auto field, auto value) {
    return [=](Scenario& s) { s.bodies[0].clusters.*field = value; };
  };
  using C = ClusterSettings;
  expectProblems({
      {"bodies.ball.soft_contact", [](Scenario& s) { s.bodies[0].soft_contact = "vertex"; }},
      {"bodies.ball.clusters.count", clusters(&C::count, -1)},
      {"bodies.ball.clusters.count", clusters(&C::count, 65537)},
      {"bodies.ball.clusters.iterations", clusters(&C::iterations, 0)},
      {"bodies.ball.clusters.rigid_hardness", clusters(&C::rigid_hardness, 1.5)},
      {"bodies.ball.clusters.kinematic_hardness", clusters(&C::kinematic_hardness, -0.1)},
      {"bodies.ball.clusters.soft_hardness", clusters(&C::soft_hardness, nan)},
      {"bodies.ball.clusters.rigid_split", clusters(&C::rigid_split, 2.0)},
      {"bodies.ball.clusters.kinematic_split", clusters(&C::kinematic_split, -1.0)},
      {"bodies.ball.clusters.soft_split", clusters(&C::soft_split, nan)},
      {"bodies.ball.clusters.node_damping", clusters(&C::node_damping, 1.1)},
      {"bodies.ball.clusters.linear_damping", clusters(&C::linear_damping, -0.1)},
      {"bodies.ball.clusters.angular_damping", clusters(&C::angular_damping, infinity)},
      {"bodies.ball.clusters.matching", clusters(&C::matching, 1.01)},
  });
}

TEST(Validate, TriangleArrays) {
  const TrianglesShape tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const auto with = [&](auto change) {
    return [=](Scenario& s) {
      TrianglesShape shape = tetrahedron;
      change(shape);
      s.bodies[0].shape = shape;
    };
  };
  Scenario good = full();
  with([](TrianglesShape&) {})(good);
  EXPECT_TRUE(validate(good).empty());
  expectProblems({
      {"bodies.ball.shape.faces.3", with([](TrianglesShape& t) { t.faces[3][1] = 4; })},
      {"bodies.ball.shape.faces.0", with([](TrianglesShape& t) { t.faces[0][0] = -1; })},
      {"bodies.ball.shape.faces.2", with([](TrianglesShape& t) {
         t.faces[2] = {1, 1, 2};
       })},
      {"bodies.ball.shape.faces", with([](TrianglesShape& t) { t.faces.pop_back(); })},
      {"bodies.ball.shape.faces", with([](TrianglesShape& t) {
         t.faces.resize(131073, {0, 1, 2});
       })},
      {"bodies.ball.shape.vertices_m.1", with([](TrianglesShape& t) { t.vertices_m[1].x() = nan; })},
  });
}

TEST(Validate, FixedRegions) {
  const BoxRegion box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  const auto with = [](const FixedRegion& region) {
    return [region](Scenario& s) { s.bodies[0].fixed = {{0.5, {}}, region}; };
  };
  Scenario good = full();
  good.bodies[0].fixed = {{0.5, {}}, {{}, box}, {{}, BoxRegion{Vec3(1, 1, 1), Vec3(1, 1, 1)}}};
  EXPECT_TRUE(validate(good).empty());
  expectProblems({
      {"bodies.ball.fixed.1", with({})},
      {"bodies.ball.fixed.1", with({0.1, box})},
      {"bodies.ball.fixed.1.below_m", with({nan, {}})},
      {"bodies.ball.fixed.1.box.min_m", with({{}, BoxRegion{Vec3(0, 1.1, 0), Vec3(1, 1, 1)}})},
      {"bodies.ball.fixed.1.box.max_m", with({{}, BoxRegion{Vec3(0, 0, 0), Vec3(1, nan, 1)}})},
  });
}

TEST(Validate, Lobes) {
  const auto with = [](auto change) {
    return [=](Scenario& s) {
      LobesShape lobes;
      change(lobes);
      s.bodies[0].shape = lobes;
    };
  };
  Scenario good = full();
  with([](LobesShape&) {})(good);
  EXPECT_TRUE(validate(good).empty());
  expectProblems({
      {"bodies.ball.shape.size_m", with([](LobesShape& l) { l.size_m.z() = 0; })},
      {"bodies.ball.shape.slit_depth_m", with([](LobesShape& l) { l.slit_depth_m = 0; })},
      {"bodies.ball.shape.slit_depth_m", with([](LobesShape& l) { l.slit_depth_m = l.size_m.y(); })},
      {"bodies.ball.shape.slit_width_m", with([](LobesShape& l) { l.slit_width_m = -0.001; })},
      {"bodies.ball.shape.slit_width_m", with([](LobesShape& l) { l.slit_width_m = l.size_m.x() / 2; })},
      {"bodies.ball.shape.edge_m", with([](LobesShape& l) { l.edge_m = nan; })},
      {"bodies.ball.shape.edge_m", with([](LobesShape& l) { l.edge_m = 1e-5; })},
  });
}

TEST(Validate, Gauges) {
  const BoxRegion box{Vec3(0, 0, 0), Vec3(1, 1, 1)};
  const auto with = [](const GaugeSettings& gauge) {
    return [gauge](Scenario& s) { s.bodies[0].gauges = {{"first", {}}, gauge}; };
  };
  Scenario good = full();
  with({"second", box})(good);
  EXPECT_TRUE(validate(good).empty());
  expectProblems({
      {"bodies.ball.gauges.1.name", with({"first", box})},
      {"bodies.ball.gauges.1.name", with({"a b", box})},
      {"bodies.ball.gauges.a.box.min_m", with({"a", BoxRegion{Vec3(2, 0, 0), Vec3(1, 1, 1)}})},
      {"bodies.ball.gauges.a.box.max_m", with({"a", BoxRegion{Vec3(0, 0, 0), Vec3(1, nan, 1)}})},
      {"bodies.twin.gauges.0.name",
       [](Scenario& s) {
         s.bodies.push_back(s.bodies[0]);
         s.bodies[1].name = "twin";
         s.bodies[0].gauges = s.bodies[1].gauges = {{"same", {}}};
       }},
  });
}

TEST(Validate, MeshFiles) {
  Scenario s = full();
  FileShape shape;
  shape.file = "organ.stl";
  shape.repairs = {"orient", "cap_holes"};
  shape.max_edge_m = 0.01;
  s.bodies[0].shape = shape;
  EXPECT_TRUE(validate(s).empty());
  const auto problem = [&](const std::function<void(FileShape&)>& change) {
    Scenario bad = s;
    change(std::get<FileShape>(bad.bodies[0].shape));
    const std::vector<Problem> problems = validate(bad);
    return problems.size() == 1 ? problems[0].path : std::to_string(problems.size()) + " problems";
  };
  const std::string path = "bodies." + s.bodies[0].name + ".shape.";
  EXPECT_EQ(problem([](FileShape& f) { f.file = ""; }), path + "file");
  EXPECT_EQ(problem([](FileShape& f) { f.weld_tolerance_m = -1e-6; }), path + "weld_tolerance_m");
  EXPECT_EQ(problem([](FileShape& f) { f.weld_tolerance_m = nan; }), path + "weld_tolerance_m");
  EXPECT_EQ(problem([](FileShape& f) { f.repairs[1] = "polish"; }), path + "repairs.1");
  EXPECT_EQ(problem([](FileShape& f) { f.repairs[1] = "orient"; }), path + "repairs.1");
  EXPECT_EQ(problem([](FileShape& f) { f.max_edge_m = 0; }), path + "max_edge_m");
  EXPECT_EQ(problem([](FileShape& f) { f.max_edge_m = infinity; }), path + "max_edge_m");
}

TEST(Validate, Scripts) {
  expectProblems({
      {"tools.1.name", [](Scenario& s) { s.tools[1].name = "blade"; }},
      {"tools.blade.shape.size_m", [](Scenario& s) { std::get<BoxShape>(s.tools[0].shape).size_m.y() = 0; }},
      {"tools.blade.nodes.resolution", [](Scenario& s) { s.tools[0].nodes.resolution[1] = 0; }},
      {"tools.blade.nodes.resolution", [](Scenario& s) { s.tools[0].nodes.resolution[0] = 513; }},
      {"tools.blade.nodes.narrow_rows", [](Scenario& s) { s.tools[0].nodes.narrow_rows = -1; }},
      {"tools.blade.friction", [](Scenario& s) { s.tools[0].friction = -1; }},
      {"tools.blade.force_limit_N", [](Scenario& s) { s.tools[0].force_limit_N = 0; }},
      {"tools.blade.force_limit_N", [](Scenario& s) { s.tools[0].force_limit_N = nan; }},
      {"tools.blade.motion.start_orientation", [](Scenario& s) { script(s).start_orientation.z() = 1; }},
      {"tools.blade.motion.segments.0.move_to_m", [](Scenario& s) { segment(s).move_to_m->x() = nan; }},
      {"tools.blade.motion.segments.0.speed_m_s", [](Scenario& s) { segment(s).speed_m_s = 0; }},
      {"tools.blade.motion.segments.0", [](Scenario& s) { segment(s).speed_m_s.reset(); }},
      {"tools.blade.motion.segments.0", [](Scenario& s) { segment(s).duration_s = 1; }},
      {"tools.blade.motion.segments.0", [](Scenario& s) { segment(s).move_to_m.reset(); }},
      {"tools.blade.motion.segments.0.speed_m_s", [](Scenario& s) { segment(s).move_to_m = Vec3::Zero(); }},
      {"tools.blade.motion.segments.0.rotate_to",
       [](Scenario& s) { segment(s).rotate_to = Quat(1, 1, 0, 0); }},
      {"tools.blade.motion.segments.0.ramp_fraction", [](Scenario& s) { segment(s).ramp_fraction = 0.6; }},
      {"tools.blade.motion.segments.0.ramp_fraction", [](Scenario& s) { segment(s).ramp_fraction = 0; }},
      {"tools.blade.motion.segments.1.speed_m_s",
       [](Scenario& s) { script(s).segments.push_back(segment(s)); }},  // a second move to the same point
      {"tools.blade.motion.segments.0.hold_s",
       [](Scenario& s) { segment(s) = {{}, {}, 0.0, {}, {}, Timing::constant, 0.25}; }},
      {"tools.blade.motion.segments.0.hold_s",
       [](Scenario& s) {  // alone: the time of the whole script would be negative
         s.tools.pop_back();
         segment(s) = {{}, {}, -1.0, {}, {}, Timing::constant, 0.25};
       }},
      {"tools.blade.motion.segments.0",
       [](Scenario& s) { segment(s) = {{}, {}, 1.0, 1.0, {}, Timing::constant, 0.25}; }},
      {"tools.blade.motion.segments.0",
       [](Scenario& s) { segment(s) = {Vec3(1, 1, 1), {}, 1.0, {}, {}, Timing::constant, 0.25}; }},
  });
}

TEST(Validate, AMoveOfNoLengthIsFineWithADuration) {
  Scenario s = full();
  segment(s) = {Vec3::Zero(), {}, {}, {}, 0.5, Timing::constant, 0.25};
  EXPECT_TRUE(validate(s).empty());
}

TEST(Validate, Replays) {
  const auto axes = [](const char* x, const char* y, const char* z) {
    return [=](Scenario& s) { replay(s).mapping.axes = {x, y, z}; };
  };
  expectProblems({
      {"tools.hand.motion.file", [](Scenario& s) { replay(s).file = ""; }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).rate_hz = 1000; }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).time_column.reset(); }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).time_column = "x"; }},
      {"tools.hand.motion", [](Scenario& s) { replay(s).position_columns[2] = ""; }},
      {"tools.hand.motion",
       [](Scenario& s) {
         replay(s).quaternion_columns = {"a", "b", "c", "y"};
       }},
      {"tools.hand.motion.mapping.axes", axes("x", "z", "y")},   // left-handed
      {"tools.hand.motion.mapping.axes", axes("x", "y", "-z")},  // left-handed
      {"tools.hand.motion.mapping.axes", axes("x", "x", "z")},   // an axis twice
      {"tools.hand.motion.mapping.axes", axes("x", "y", "w")},   // no such axis
      {"tools.hand.motion.mapping.axes", axes("", "y", "z")},
      {"tools.hand.motion.mapping.axes", axes("--x", "y", "z")},
      {"tools.hand.motion.mapping.scale", [](Scenario& s) { replay(s).mapping.scale = 0; }},
      {"tools.hand.motion.mapping.mount", [](Scenario& s) { replay(s).mapping.mount = Quat(0, 0, 0, 0); }},
      {"tools.hand.motion.start_s", [](Scenario& s) { replay(s).start_s = -1; }},
      {"tools.hand.motion.end_s", [](Scenario& s) { replay(s).end_s = 0; }},
      {"tools.hand.motion.max_gap_s", [](Scenario& s) { replay(s).max_gap_s = 0; }},
      {"tools.hand.motion.jump_m", [](Scenario& s) { replay(s).jump_m = nan; }},
  });
  for (const auto& good : {axes("x", "-z", "y"), axes("-x", "-y", "z"), axes("y", "z", "x")}) {
    Scenario s = full();
    good(s);
    EXPECT_TRUE(validate(s).empty());
  }
}

TEST(Validate, PipelinesForcesAndRecords) {
  expectProblems({
      {"pipelines.1.name", [](Scenario& s) { s.pipelines[1].name = "default"; }},
      {"pipelines.default.pipeline", [](Scenario& s) { s.pipelines[0].pipeline = "defualt"; }},
      {"pipelines.default.precision", [](Scenario& s) { s.pipelines[0].precision = "f16"; }},
      {"pipelines.default.settings", [](Scenario& s) { s.pipelines[0].settings = "best"; }},
      {"pipelines.default.sdf_voxel_m", [](Scenario& s) { s.pipelines[0].sdf_voxel_m = 0; }},
      {"pipelines.default.kinematic_hardness", [](Scenario& s) { s.pipelines[0].kinematic_hardness = 2; }},
      {"pipelines.fukuhara.ray_length_m", [](Scenario& s) { s.pipelines[1].ray_length_m = -1; }},
      {"pipelines.fukuhara.response", [](Scenario& s) { s.pipelines[1].response = "soft"; }},
      {"pipelines.fukuhara.sweeps", [](Scenario& s) { s.pipelines[1].sweeps = 0; }},
      {"pipelines.fukuhara.sweeps", [](Scenario& s) { s.pipelines[1].sweeps = 1001; }},
      {"pipelines.fukuhara.max_displacement_m", [](Scenario& s) { s.pipelines[1].max_displacement_m = 0; }},
      {"pipelines.fukuhara.time_limit_s", [](Scenario& s) { s.pipelines[1].time_limit_s = 0; }},
      {"force.hc.model", [](Scenario& s) { s.force[0].model = "hertz"; }},
      {"force.hc.k", [](Scenario& s) { s.force[0].k = -1; }},
      {"force.hc.lambda", [](Scenario& s) { s.force[0].lambda = nan; }},
      {"force.hc.n", [](Scenario& s) { s.force[0].n = 0; }},
      {"force.hc.c", [](Scenario& s) { s.force[0].c = -1; }},
      {"force.hc.rate", [](Scenario& s) { s.force[0].rate = "speed"; }},
      {"force.hc.deformation", [](Scenario& s) { s.force[0].deformation = "rigid"; }},
      {"record.snapshots_every_s", [](Scenario& s) { s.record.snapshots_every_s = 0.0009; }},
      {"record.snapshots_every_s", [](Scenario& s) { s.record.snapshots_every_s = nan; }},
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

TEST(Validate, TheLongestScriptIsTheDurationWhereNoneIsGiven) {
  // 1 m at 2 m/s and a hold of 0.25 s: 0.75 s.
  Scenario s = full();
  s.tools.pop_back();
  s.record = {};
  script(s).segments.push_back({{}, {}, 0.25, {}, {}, Timing::constant, 0.25});
  s.time.step_s = 0.75;
  EXPECT_TRUE(validate(s).empty());
  s.time.step_s = 0.7501;
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_EQ(validate(s)[0].message, "is 0.7501, expected at most the duration, 0.75 s");
  script(s).segments.clear();
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_EQ(validate(s)[0].path, "time");
  s.tools.clear();
  ASSERT_EQ(validate(s).size(), 1u);
  EXPECT_EQ(validate(s)[0].path, "time");
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
  for (const char* pipeline : {"default", "null", "cluster", "fukuhara", "prescribed"}) {
    s.pipelines = {{.name = "p", .pipeline = pipeline}};
    s.tools[0].friction = 0.5;
    EXPECT_TRUE(validate(s).empty()) << pipeline;
  }
  for (const PipelineSettings& entry :
       {PipelineSettings{.name = "p", .pipeline = "raycast"},
        PipelineSettings{.name = "p", .pipeline = "fukuhara", .response = "none"}}) {
    s.pipelines = {entry};
    s.tools[0].friction = 0.5;
    ASSERT_EQ(validate(s).size(), 1u) << entry.pipeline;
    EXPECT_EQ(validate(s)[0].path, "tools.blade.friction");
    s.tools[0].friction = 0;
    EXPECT_TRUE(validate(s).empty()) << entry.pipeline;
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

}  // namespace fissure
