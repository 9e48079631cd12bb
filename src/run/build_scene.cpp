#include "run/build_scene.h"

#include "contact/grid_nodes.h"
#include "mesh/fixed_vertices.h"
#include "mesh/place.h"
#include "mesh/primitives.h"

namespace fissure {

Scene buildScene(const Scenario& scenario, bool with_nodes) {
  Scene scene;
  for (const BodySettings& body : scenario.bodies) {
    scene.bodies.push_back({.name = body.name,
                            .rest = placeBody(body),
                            .first_vertex = scene.vertexCount(),
                            .first_face = scene.faceCount()});
    scene.bodies.back().fixed_vertices = fixedVertices(body, scene.bodies.back().rest);
  }
  for (const ToolSettings& tool : scenario.tools) {
    scene.tools.push_back(
        {.name = tool.name,
         .surface = makeBox(tool.shape.size_m),
         .box_size_m = tool.shape.size_m,
         .nodes = with_nodes ? makeGridNodes(tool.shape.size_m, tool.nodes.resolution) : ToolNodes{},
         .first_node = scene.nodeCount()});
  }
  if (scenario.ground) scene.ground_height_m = scenario.ground->height_m;
  return scene;
}

}  // namespace fissure
