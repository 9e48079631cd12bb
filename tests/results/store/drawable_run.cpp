#include "drawable_run.h"

#include <cmath>

#include "sample_run.h"
#include "store/part_file.h"

namespace fissure {

namespace {

TriangleMesh boxSurface(const Vec3& size_m) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices_m.push_back(
        size_m.cwiseProduct(Vec3((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, (corner >> 2) - 0.5)));
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Quat turned(double angle, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

RecordLayout layoutOf(const Scene& scene) {
  RecordLayout layout;
  RecordAxis tool{"tool", {}};
  for (const SceneTool& made : scene.tools) tool.labels.push_back(made.name);
  layout.addAxis(tool);
  layout.addAxis({"xyz", {"x", "y", "z"}});
  layout.addAxis({"quat", {"x", "y", "z", "w"}});
  layout.addAxis({"clamp", {"clamp"}});
  layout.add({"time", "s", "simulated time", ValueType::real, {}});
  layout.add({"penetration_depth", "m", "deepest penetration", ValueType::real, {}});
  layout.add({"tool_position", "m", "tool positions", ValueType::real, {"tool", "xyz"}});
  layout.add({"tool_quaternion", "1", "tool orientations", ValueType::real, {"tool", "quat"}});
  layout.add({"jaw_opening", "m", "opening", ValueType::real, {"clamp"}});
  return layout;
}

RecordRow rowOf(const RecordLayout& layout, const State& state, double depth_m) {
  RecordRow row(layout.columns());
  const auto at = [&](const char* name) { return &row[layout.find(name)->first_column]; };
  *at("time") = state.time_s;
  *at("penetration_depth") = depth_m;
  for (std::size_t t = 0; t < state.tools.size(); ++t) {
    const Pose& pose = state.tools[t].pose;
    std::copy_n(pose.position_m.data(), 3, at("tool_position") + 3 * t);
    std::copy_n(pose.orientation.coeffs().data(), 4, at("tool_quaternion") + 4 * t);
  }
  return row;
}

}  // namespace

Scene drawableScene() {
  Scene scene;
  scene.ground_height_m = -0.03;
  scene.bodies = {{"liver", boxSurface({0.06, 0.04, 0.05}), 0, 0},
                  {"kidney", boxSurface({0.02, 0.02, 0.02}), 8, 12}};
  scene.tools = {{.name = "spatula", .surface = boxSurface({0.04, 0.002, 0.015})},
                 {.name = "clamp_left", .surface = boxSurface({0.003, 0.03, 0.01})},
                 {.name = "clamp_right", .surface = boxSurface({0.003, 0.03, 0.01})}};
  ToolNodes& nodes = scene.tools[0].nodes;
  nodes.positions_m = {{-0.01, 0.001, 0}, {0.01, 0.001, 0}, {-0.01, -0.001, 0}, {0.01, -0.001, 0}};
  nodes.normals = {{0, 1, 0}, {0, 1, 0}, {0, -1, 0}, {0, -1, 0}};
  nodes.partners = {2, 3, 0, 1};
  nodes.thicknesses_m.assign(4, 0.002);
  scene.tools[1].first_node = scene.tools[2].first_node = 4;
  scene.clamps = {
      {.name = "clamp", .left_tool = 1, .right_tool = 2, .handle = boxSurface({0.03, 0.01, 0.01})}};
  return scene;
}

State drawableState(std::size_t snapshot) {
  const double k = static_cast<double>(snapshot);
  const Scene scene = drawableScene();
  State state;
  state.time_s = k / 10;
  for (const SceneBody& body : scene.bodies)
    for (const Vec3& vertex_m : body.rest.vertices_m)
      state.positions_m.push_back(vertex_m * (1 - k / 30) + Vec3(0.05 * (body.first_vertex > 0), k / 300, 0));
  state.contact.vertex_contact.assign(state.positions_m.size(), 0);
  const Vec3 jaw_m(0.02 - k / 1000, 0.04, 0.04);
  state.tools = {{.pose = {{0, 0.03 - k / 100, 0.02}, turned(0.1 + k / 7, {1, 2, 3})}},
                 {.pose = {-jaw_m, turned(k / 9, {0, 1, 0})}},
                 {.pose = {jaw_m, turned(k / 9, {0, 1, 0})}}};
  state.clamps = {{{{0.01, 0.05 - k / 300, 0.03}, turned(k / 11, {3, 1, 0})}, 0.01}};
  state.contact.node_states = {NodeState::free, NodeState::feasible, NodeState::infeasible,
                               NodeState::capped};
  return state;
}

double drawableDepth_m(std::size_t snapshot) {
  return 0.001 * static_cast<double>(snapshot) / 3;
}

void writeDrawableResult(const std::filesystem::path& path, const std::vector<DrawableRun>& runs) {
  const ScratchFolder folder;
  const Scene scene = drawableScene();
  const RecordLayout layout = layoutOf(scene);
  LoadedScenario loaded;
  loaded.scenario.name = "drawn";
  loaded.scenario.record.snapshots_every_s = 0.1;
  loaded.scenario.time.step_s = 0.05;
  std::vector<PartResult> parts;
  for (const DrawableRun& run : runs) {
    PipelineSettings entry;
    entry.name = run.name;
    const std::filesystem::path part = folder / (run.name + ".part");
    const auto sink = createPartFile(
        part, {.scenario = loaded.scenario, .pipeline = entry, .scene = scene, .layout = layout});
    for (std::size_t k = 0; k < run.snapshots; ++k) {
      State state = drawableState(k);
      sink->append(rowOf(layout, state, drawableDepth_m(k)));
      sink->snapshot(state);
      state.time_s += 0.05;  // a step without a snapshot, whose depth is another one
      sink->append(rowOf(layout, state, 1));
    }
    sink->finish({run.end, ""}, {});
    parts.push_back({entry, part, {run.end, ""}});
  }
  assembleResult(path, loaded, {}, parts);
}

}  // namespace fissure
