#include "run/build_scene.h"

#include "contact/grid_nodes.h"
#include "mesh/file_surface.h"
#include "mesh/fixed_vertices.h"
#include "mesh/place.h"
#include "mesh/primitives.h"

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

}  // namespace

Scene buildScene(const Scenario& scenario, bool with_nodes) {
  Scene scene;
  for (const BodySettings& body : scenario.bodies) {
    SceneBody placed = makeBody(body, scenario.directory);
    placed.first_vertex = scene.vertexCount();
    placed.first_face = scene.faceCount();
    placed.fixed_vertices = fixedVertices(body, placed.rest);
    for (const GaugeSettings& gauge : body.gauges)
      placed.gauges.push_back({gauge.name, verticesIn(gauge.box, placed.rest)});
    scene.bodies.push_back(std::move(placed));
  }
  for (const ToolSettings& tool : scenario.tools) {
    scene.tools.push_back(
        {.name = tool.name,
         .surface = makeBox(tool.shape.size_m),
         .box_size_m = tool.shape.size_m,
         .nodes = with_nodes ? makeGridNodes(tool.shape.size_m, tool.nodes.resolution, tool.nodes.narrow_rows)
                             : ToolNodes{},
         .first_node = scene.nodeCount()});
  }
  if (scenario.ground) scene.ground_height_m = scenario.ground->height_m;
  return scene;
}

}  // namespace fissure
