#include "validate_changes.h"

namespace fissure::validate_bodies_test {

namespace {

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

TEST(Validate, CellsOfABox) {
  const auto cells = [](int x, int y, int z) {
    return [=](Scenario& s) { s.bodies[0].shape = BoxShape{{1, 1, 1}, {x, y, z}}; };
  };
  for (const auto& good : {cells(1, 1, 128), cells(128, 64, 128), cells(104, 104, 104)}) {
    Scenario scenario = full();
    good(scenario);
    EXPECT_TRUE(validate(scenario).empty());
  }
  const char* path = "bodies.ball.shape.cells";
  expectProblems({{path, cells(0, 1, 1)},
                  {path, cells(1, -1, 1)},
                  {path, cells(1, 1, 129)},
                  {path, cells(128, 65, 128)},
                  {path, cells(105, 105, 105)}});
  EXPECT_EQ((BoxShape{{1, 1, 1}, {128, 64, 128}}.triangles()), static_cast<double>(most_triangles));
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
  shape.repairs = {MeshRepair::orient, MeshRepair::cap_holes};
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
  EXPECT_EQ(problem([](FileShape& f) { f.repairs[1] = MeshRepair::orient; }), path + "repairs.1");
  EXPECT_EQ(problem([](FileShape& f) { f.max_edge_m = 0; }), path + "max_edge_m");
  EXPECT_EQ(problem([](FileShape& f) { f.max_edge_m = infinity; }), path + "max_edge_m");
}

}  // namespace

}  // namespace fissure::validate_bodies_test
