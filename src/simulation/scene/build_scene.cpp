#include "scene/build_scene.h"

#include <fmt/core.h>

#include "base/error.h"
#include "contact/centroid_nodes.h"
#include "contact/grid_nodes.h"
#include "mesh/check.h"
#include "mesh/orient.h"
#include "mesh/subdivide.h"
#include "scenario/rigid_tools.h"
#include "scene/fixed_vertices.h"
#include "scene/place.h"

namespace fissure {

namespace {

/// What was repaired of a shape that is a file's.
std::vector<std::string> repairsOf(const SurfaceShape& shape, const MeshFiles& files) {
  const auto* from_file = std::get_if<FileShape>(&shape);
  return from_file ? files.surface(*from_file).repairs : std::vector<std::string>();
}

ToolNodes makeNodes(const ToolSettings& tool, const TriangleMesh& surface) {
  const NodeSettings& nodes = tool.nodes;
  if (tool.nodePlacement() == NodePlacement::grid)
    return makeGridNodes(std::get<BoxShape>(tool.shape).size_m, nodes.resolution, nodes.narrow_rows);
  const CentroidNodeSettings settings{nodes.pairing_limit, nodes.lone_nodes, nodes.rim_nodes};
  TriangleMesh fine = surface;
  const bool few = nodes.max_spacing_m ? subdivide(fine, *nodes.max_spacing_m, most_triangles)
                                       : fine.faces.size() <= most_triangles;
  if (!few)
    throw InputError(fmt::format("tools.{}.nodes{}: in more than {} triangles, expected fewer", tool.name,
                                 nodes.max_spacing_m ? ".max_spacing_m" : "", most_triangles));
  return makeCentroidNodes(fine, settings);
}

SceneTool makeTool(const ToolSettings& tool, const MeshFiles& files, bool with_nodes) {
  SceneTool made{
      .name = tool.name, .surface = makeSurface(tool.shape, files), .repairs = repairsOf(tool.shape, files)};
  if (const auto* box = std::get_if<BoxShape>(&tool.shape)) made.box_size_m = box->size_m;
  if (tool.mirrored) mirror(made.surface);
  made.closed = hasInside(made.surface);
  if (with_nodes) made.nodes = makeNodes(tool, made.surface);
  return made;
}

/// All parts of a handle as one surface, in the clamp's frame.
TriangleMesh makeHandle(const std::vector<ClampPart>& parts, const MeshFiles& files) {
  TriangleMesh handle;
  for (const ClampPart& part : parts) {
    const Pose pose{part.position_m, part.orientation.normalized()};
    const TriangleMesh shape = makeSurface(part.shape, files);
    const int first = static_cast<int>(handle.vertices_m.size());
    for (const Vec3& vertex_m : shape.vertices_m) handle.vertices_m.push_back(pose.toScene(vertex_m));
    for (const Face& face : shape.faces)
      handle.faces.push_back({first + face[0], first + face[1], first + face[2]});
  }
  return handle;
}

void addClamp(const ToolSettings& clamp, const MeshFiles& files, bool drawn, Scene& scene) {
  const int left = static_cast<int>(scene.tools.size());
  scene.clamps.push_back({.name = clamp.name,
                          .left_tool = left,
                          .right_tool = left + 1,
                          .hinged = clamp.clamp->opening == ClampOpening::hinged,
                          .handle = drawn ? makeHandle(clamp.clamp->handle, files) : TriangleMesh{}});
}

}  // namespace

Scene buildScene(const Scenario& scenario, bool with_nodes, const MeshFiles& files) {
  Scene scene;
  for (const BodySettings& body : scenario.bodies) {
    SceneBody placed{
        .name = body.name, .rest = placeBody(body, files), .repairs = repairsOf(body.shape, files)};
    placed.first_vertex = scene.vertexCount();
    placed.first_face = scene.faceCount();
    placed.fixed_vertices = fixedVertices(body, placed.rest.vertices_m);
    if (body.isElastic()) placed.volume = placeVolume(body, files);
    for (const GaugeSettings& gauge : body.gauges)
      placed.gauges.push_back({gauge.name, verticesIn(gauge.box, placed.rest)});
    scene.bodies.push_back(std::move(placed));
  }
  const bool drawn = scenario.record.frames || scenario.record.snapshots_every_s;
  for (const ToolSettings& tool : scenario.tools) {
    if (tool.clamp) addClamp(tool, files, drawn, scene);
    for (const ToolSettings& rigid : rigidTools({tool})) {
      SceneTool made = makeTool(rigid, files, with_nodes);
      made.first_node = scene.nodeCount();
      scene.tools.push_back(std::move(made));
    }
  }
  if (scenario.ground) scene.ground_height_m = scenario.ground->height_m;
  return scene;
}

Scene buildScene(const Scenario& scenario, bool with_nodes) {
  return buildScene(scenario, with_nodes, MeshFiles(scenario.directory));
}

void adaptTo(const PipelineSettings& pipeline, Scene& scene) {
  scene.ground_reaction_known = scene.ground_height_m && (pipeline.ownGround() || pipeline.usesVolume());
  if (pipeline.usesNodes()) return;
  for (SceneTool& tool : scene.tools) {
    tool.nodes = {};
    tool.first_node = 0;
  }
}

}  // namespace fissure
