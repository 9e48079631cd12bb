#include "run/build_scene.h"

#include "contact/grid_nodes.h"
#include "mesh/file_surface.h"
#include "mesh/fixed_vertices.h"
#include "mesh/place.h"
#include "mesh/primitives.h"
#include "scenario/rigid_tools.h"

namespace fissure {

namespace {

SceneBody makeBody(const BodySettings& body, const std::filesystem::path& directory) {
  if (const auto* shape = std::get_if<FileShape>(&body.shape)) {
    FileSurface surface = loadSurface(*shape, directory);
    return {.name = body.name,
            .rest = placeBody(body, std::move(surface.mesh)),
            .repairs = std::move(surface.repairs)};
  }
  return {.name = body.name, .rest = placeBody(body, directory)};
}

void addTool(const ToolSettings& tool, bool with_nodes, Scene& scene) {
  scene.tools.push_back(
      {.name = tool.name,
       .surface = makeBox(tool.shape.size_m),
       .box_size_m = tool.shape.size_m,
       .nodes = with_nodes ? makeGridNodes(tool.shape.size_m, tool.nodes.resolution) : ToolNodes{},
       .first_node = scene.nodeCount()});
}

/// All parts of a handle as one surface, in the clamp's frame.
TriangleMesh makeHandle(const std::vector<ClampPart>& parts) {
  TriangleMesh handle;
  for (const ClampPart& part : parts) {
    const Pose pose{part.position_m, part.orientation.normalized()};
    const TriangleMesh shape = makeBox(part.shape.size_m);
    const int first = static_cast<int>(handle.vertices_m.size());
    for (const Vec3& vertex_m : shape.vertices_m) handle.vertices_m.push_back(pose.toScene(vertex_m));
    for (const Face& face : shape.faces)
      handle.faces.push_back({first + face[0], first + face[1], first + face[2]});
  }
  return handle;
}

void addClamp(const ToolSettings& clamp, bool drawn, Scene& scene) {
  const int left = static_cast<int>(scene.tools.size());
  scene.clamps.push_back({.name = clamp.name,
                          .left_tool = left,
                          .right_tool = left + 1,
                          .hinged = clamp.clamp->opening == ClampOpening::hinged,
                          .handle = drawn ? makeHandle(clamp.clamp->handle) : TriangleMesh{}});
}

}  // namespace

Scene buildScene(const Scenario& scenario, bool with_nodes) {
  Scene scene;
  for (const BodySettings& body : scenario.bodies) {
    SceneBody placed = makeBody(body, scenario.directory);
    placed.first_vertex = scene.vertexCount();
    placed.first_face = scene.faceCount();
    placed.fixed_vertices = fixedVertices(body, placed.rest);
    scene.bodies.push_back(std::move(placed));
  }
  for (const ToolSettings& tool : scenario.tools) {
    if (tool.clamp) addClamp(tool, scenario.record.frames.has_value(), scene);
    for (const ToolSettings& rigid : rigidTools({tool})) addTool(rigid, with_nodes, scene);
  }
  if (scenario.ground) scene.ground_height_m = scenario.ground->height_m;
  return scene;
}

}  // namespace fissure
