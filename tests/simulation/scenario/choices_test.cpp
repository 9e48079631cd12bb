// Walks the tables of pipelines, shapes and motions through every place that has to know an entry: an entry
// that is forgotten somewhere does not compile, or fails here. What the engines make of each pipeline:
// engine/simulation_test.cpp and programs/run_test.cpp.
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "mesh/check.h"
#include "mesh/tetrahedra_check.h"
#include "motion/motion.h"
#include "scenario/catalog.h"
#include "scenario_text.h"
#include "scene/place.h"

namespace fissure::choices_test {

namespace {

TEST(PipelineTable, IsInTheOrderOfItsKindsAndListed) {
  const std::vector<CatalogEntry>& listed = catalog().pipelines;
  ASSERT_EQ(listed.size(), pipeline_table.size());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(pipeline_table[i].kind), i);
    EXPECT_EQ(&traitsOf(pipeline_table[i].kind), &pipeline_table[i]);
    EXPECT_EQ(nameIn(listed, pipeline_table[i].kind), pipeline_table[i].name);
    EXPECT_EQ(listed[i].description, pipeline_table[i].description);
  }
}

/// The smallest scenario with these keys of a pipeline, as the file `a.yaml` would give it, of a body that
/// the pipeline is for.
LoadedScenario withPipeline(const PipelineTraits& pipeline, const std::string& keys) {
  const std::string entry = "[{pipeline: \"" + std::string(pipeline.name) + "\"" + keys + "}]";
  std::vector<Override> overrides = {{"pipelines", entry}};
  if (pipeline.detection == ContactDetection::volume) overrides.push_back({"bodies.ball.model", "elastic"});
  return parseScenario(smallest_text, "a.yaml", overrides);
}

TEST(PipelineTable, EachEntryIsReadFilledValidatedAndWrittenBack) {
  for (const PipelineTraits& pipeline : pipeline_table) {
    const LoadedScenario loaded = withPipeline(pipeline, "");
    const PipelineSettings& entry = loaded.scenario.pipelines.at(0);
    EXPECT_EQ(entry.pipeline, pipeline.kind) << pipeline.name;
    EXPECT_EQ(entry.name, pipeline.name);
    EXPECT_TRUE(validate(loaded.scenario).empty()) << pipeline.name;
    EXPECT_EQ(parseScenario(loaded.resolved, "a.yaml").scenario, loaded.scenario) << loaded.resolved;
    const bool nodes = pipeline.detection == ContactDetection::nodes;
    EXPECT_EQ(entry.response, nodes ? std::optional(pipeline.response) : std::nullopt) << pipeline.name;
    EXPECT_EQ(entry.vertex_contacts, nodes ? std::optional(pipeline.vertex_contacts) : std::nullopt);
    const bool sdf = pipeline.detection == ContactDetection::sdf;
    EXPECT_EQ(entry.sdf_voxel_m, sdf ? std::optional(pipeline.stock.sdf_voxel_m) : std::nullopt);
    EXPECT_GT(pipeline.tuned.sdf_voxel_m, 0) << pipeline.name;
  }
}

/// Where a key has a meaning it is read; elsewhere the message names exactly the pipelines where it has.
TEST(PipelineTable, EachKeyHasAMeaningForTheDetectionsThatUseIt) {
  using enum ContactDetection;
  struct Key {
    std::string text;
    std::vector<ContactDetection> detections;
    std::string names;
  };
  const std::vector<Key> keys = {
      {"settings: tuned", {sdf, clusters, volume}, "pipelines default, null, cluster and deformable"},
      {"contacts: nodes", {volume}, "pipeline deformable"},
      {"contacts: nodes, sdf_voxel_m: 0.01", {volume}, "pipeline deformable"},
      {"deformable: {substeps: 3}", {volume}, "pipeline deformable"},
      {"sdf_voxel_m: 0.01", {sdf}, "pipelines default and null, or pipeline deformable with contacts nodes"},
      {"kinematic_hardness: 0.5", {sdf}, "pipelines default and null"},
      {"ray_length_m: 0.1", {nodes}, "pipelines raycast and fukuhara"},
      {"vertex_contacts: true", {nodes}, "pipelines raycast and fukuhara"},
      {"response: none", {nodes}, "pipelines raycast and fukuhara"},
      {"ground_contact: bullet", {nodes}, "pipelines raycast and fukuhara"},
      {"sweeps: 5", {nodes, surface}, "pipelines raycast, fukuhara and swept"},
      {"max_displacement_m: 0.01", {nodes, surface}, "pipelines raycast, fukuhara and swept"},
      {"rounds: 2", {surface}, "pipeline swept"}};
  for (const PipelineTraits& pipeline : pipeline_table) {
    for (const Key& key : keys) {
      const std::string error = inputError([&] { withPipeline(pipeline, ", " + key.text); });
      const bool used =
          std::find(key.detections.begin(), key.detections.end(), pipeline.detection) != key.detections.end();
      const std::string end = "has no meaning here, expected it only for " + key.names;
      EXPECT_TRUE(used ? error == "nothing" : error.ends_with(end)) << pipeline.name << ": " << error;
    }
  }
}

/// A shape of each kind, with values that are not its defaults.
std::vector<SurfaceShape> shapes() {
  FileShape file;
  file.file = "tetrahedron.off";
  file.unit = LengthUnit::mm;
  file.weld_tolerance_m = 1e-9;
  file.repairs = {MeshRepair::orient};
  file.max_edge_m = 0.02;
  const std::vector<Vec3> corners_m = {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}};
  return {SphereShape{0.02, 3},
          BoxShape{Vec3(0.01, 0.02, 0.03), {2, 1, 4}},
          TrianglesShape{corners_m, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}},
          file,
          CapsuleShape{0.01, 0.05, 1},
          LobesShape{{0.06, 0.03, 0.07}, 0.02, 0.002, 0.005},
          TetrahedraShape{"tetrahedron.vtk", LengthUnit::cm}};
}

bool isFromFile(const SurfaceShape& shape) {
  return std::holds_alternative<FileShape>(shape) || std::holds_alternative<TetrahedraShape>(shape);
}

/// A motion of each kind, with values that are not its defaults.
std::vector<ToolMotion> motions() {
  ScriptMotion script;
  script.start_m = Vec3(0, 0.1, 0);
  script.segments = {MotionSegment{.move_to_m = Vec3(0, 0.05, 0), .speed_m_s = 0.1},
                     MotionSegment{.hold_s = 0.25}};
  ReplayMotion replay;
  replay.file = "hand.csv";
  replay.rate_hz = 100;
  replay.mapping.scale = 2;
  return {script, replay};
}

/// The scenarios below, written and read again, are in this folder: the files that they name are there.
class Choices : public ScenarioFiles {
 protected:
  Choices() {
    write("tetrahedron.off",
          "OFF\n4 4 0\n0 0 0\n10 0 0\n0 10 0\n0 0 10\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    write("tetrahedron.vtk",
          "# vtk DataFile Version 3.0\none\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 0\n"
          "0 1 0\n0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
    write("hand.csv", "x,y,z\n0,0,0\n0.01,0,0\n0.01,0.02,0\n");
  }
  LoadedScenario again(const Scenario& scenario) const {
    return parseScenario(toYaml(scenario), folder_ / "a.yaml");
  }
};

TEST_F(Choices, HaveAnExampleOfEachShapeAndMotion) {
  std::set<std::size_t> shape_kinds, motion_kinds;
  for (const SurfaceShape& shape : shapes()) shape_kinds.insert(shape.index());
  for (const ToolMotion& motion : motions()) motion_kinds.insert(motion.index());
  EXPECT_EQ(shape_kinds.size(), std::variant_size_v<SurfaceShape>);
  EXPECT_EQ(motion_kinds.size(), std::variant_size_v<ToolMotion>);
}

TEST_F(Choices, EachShapeIsListedForBodiesAndTools) {
  ASSERT_EQ(catalog().body_shapes.size(), std::variant_size_v<SurfaceShape>);
  ASSERT_EQ(catalog().tool_shapes.size(), std::variant_size_v<SurfaceShape>);
  for (const SurfaceShape& shape : shapes()) {
    const ShapeText text = std::visit([](const auto& one) { return one.text; }, shape);
    EXPECT_EQ(catalog().body_shapes[shape.index()].name, text.name);
    EXPECT_EQ(catalog().tool_shapes[shape.index()].name, text.name);
    EXPECT_EQ(catalog().body_shapes[shape.index()].description, text.as_body);
    EXPECT_EQ(catalog().tool_shapes[shape.index()].description, text.as_tool);
  }
}

TEST_F(Choices, EachShapeIsReadValidatedAndWrittenBackForBodiesAndTools) {
  for (const SurfaceShape& shape : shapes()) {
    Scenario scenario = smallest();
    scenario.directory = folder_;
    scenario.bodies[0].shape = shape;
    ToolSettings tool;
    tool.name = "tool";
    tool.shape = shape;
    tool.nodes.placement = tool.nodePlacement();
    scenario.tools = {tool};
    const std::string name(catalog().body_shapes[shape.index()].name);
    EXPECT_TRUE(validate(scenario).empty()) << name;
    const LoadedScenario loaded = again(scenario);
    EXPECT_EQ(loaded.scenario, scenario) << loaded.resolved;
    const bool from_file = isFromFile(shape);
    EXPECT_EQ(loaded.inputs.size(), from_file ? 2u : 0u) << name;
  }
}

TEST_F(Choices, EachShapeHasAGoodSurfaceOfAsManyTrianglesAsItPromises) {
  for (const SurfaceShape& shape : shapes()) {
    const TriangleMesh surface = makeSurface(shape, MeshFiles(folder_));
    const std::string name(catalog().body_shapes[shape.index()].name);
    EXPECT_TRUE(inspectSurface(surface).empty()) << name;
    EXPECT_EQ(trianglesOf(shape).has_value(), !isFromFile(shape)) << name;
    EXPECT_EQ(static_cast<double>(surface.faces.size()), trianglesOf(shape).value_or(4)) << name;
  }
}

TEST_F(Choices, EachShapeHasAGoodVolumeInItsSurface) {
  const MeshFiles files(folder_);
  for (const SurfaceShape& shape : shapes()) {
    BodySettings body;
    body.shape = shape;
    body.model = BodyModel::elastic;
    const std::string name(catalog().body_shapes[shape.index()].name);
    const TetrahedralMesh volume = placeVolume(body, files).mesh;
    EXPECT_TRUE(inspectTetrahedra(volume, placeBody(body, files)).empty()) << name;
    EXPECT_EQ(tetrahedraOf(shape).has_value(), !isFromFile(shape) && name != "triangles") << name;
    const double tetrahedra = static_cast<double>(volume.tetrahedra.size());
    EXPECT_EQ(tetrahedra, tetrahedraOf(shape).value_or(tetrahedra)) << name;
  }
}

TEST_F(Choices, EachMotionIsListedReadValidatedAndWrittenBack) {
  ASSERT_EQ(catalog().motions.size(), std::variant_size_v<ToolMotion>);
  for (const ToolMotion& motion : motions()) {
    const MotionText text = std::visit([](const auto& one) { return one.text; }, motion);
    EXPECT_EQ(catalog().motions[motion.index()].name, text.name);
    EXPECT_EQ(catalog().motions[motion.index()].description, text.description);
    EXPECT_FALSE(text.in_plan.empty()) << text.name;
    Scenario scenario = smallest();
    scenario.directory = folder_;
    ToolSettings tool;
    tool.name = "tool";
    tool.nodes.placement = NodePlacement::grid;
    tool.motion = motion;
    scenario.tools = {tool};
    EXPECT_TRUE(validate(scenario).empty()) << text.name;
    const LoadedScenario loaded = again(scenario);
    EXPECT_EQ(loaded.scenario, scenario) << loaded.resolved;
    EXPECT_EQ(loaded.inputs.size(), std::holds_alternative<ReplayMotion>(motion) ? 1u : 0u) << text.name;
  }
}

TEST_F(Choices, EachMotionMovesAToolForAsLongAsItPromises) {
  for (const ToolMotion& settings : motions()) {
    ToolSettings tool;
    tool.name = "tool";
    tool.motion = settings;
    const auto motion = makeMotion(tool, folder_);
    const std::string name(catalog().motions[settings.index()].name);
    const std::optional<double> promised_s =
        std::visit([](const auto& one) { return one.knownDuration_s(); }, settings);
    EXPECT_GT(motion->duration_s(), 0) << name;
    EXPECT_NEAR(motion->duration_s(), promised_s.value_or(motion->duration_s()), 1e-12) << name;
    const Vec3 first_m = motion->poseAt(0).position_m, last_m = motion->poseAt(1e3).position_m;
    EXPECT_GT((last_m - first_m).norm(), 1e-3) << name;
    EXPECT_EQ(motion->poseAt(motion->duration_s()).position_m, last_m) << name;
    EXPECT_EQ(motion->openingAt(0), 0) << name;
  }
}

}  // namespace

}  // namespace fissure::choices_test
