#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "base/tetrahedra.h"
#include "base/tool_nodes.h"

namespace fissure {

/// Vertices whose mean displacement is recorded.
struct Gauge {
  std::string name;
  std::vector<int> vertices;  ///< indices in its body, at least one
};

/// The inside of an elastic body as placed at time zero.
struct SceneVolume {
  TetrahedralMesh mesh;             ///< scene frame; its first vertices are those of the body's surface
  std::vector<int> fixed_vertices;  ///< indices in `mesh`, ascending; these vertices never move
  /// [tetrahedron] 0, or 1 + the index of its region in the body's settings; empty: the body has no regions.
  std::vector<int> regions = {};
};

/// A soft body as placed at time zero.
struct SceneBody {
  std::string name;
  /// Surface in the scene frame, closed, with outward faces; its indices count from this body's first vertex.
  TriangleMesh rest;
  int first_vertex = 0;  ///< offset of this body in the [vertex] arrays of a State, which cover all bodies
  int first_face = 0;
  std::vector<int> fixed_vertices = {};  ///< indices in this body, ascending; these vertices never move
  std::vector<Gauge> gauges = {};
  std::optional<SceneVolume> volume = {};  ///< elastic bodies only
  std::vector<std::string> repairs;        ///< repairs of the surface read from its file, one line each
};

/// A rigid, kinematic tool, in its own frame.
struct SceneTool {
  std::string name;
  TriangleMesh surface;            ///< outward faces
  std::optional<Vec3> box_size_m;  ///< full edge lengths when the tool is a box centred on its origin
  bool closed = true;              ///< false: the surface has no inside
  ToolNodes nodes;                 ///< empty for pipelines that use none
  int first_node = 0;  ///< offset of this tool in the [node] arrays of a State, which cover all tools
  std::vector<std::string> repairs = {};  ///< repairs of the surface read from its file, one line each
};

/// Two tools that are the jaws of a clamp.
struct SceneClamp {
  std::string name;
  int left_tool = 0;  ///< index in Scene::tools
  int right_tool = 0;
  /// True: its opening is an angle in degrees; false: the distance between the jaws in metres.
  bool hinged = false;
  TriangleMesh handle;  ///< parts that are drawn only, in the clamp's frame; may be empty
};

/// The geometry of one run, shared by engine, measure, render and store. Built once from a scenario.
struct Scene {
  std::vector<SceneBody> bodies;
  std::vector<SceneTool> tools;
  std::vector<SceneClamp> clamps;
  std::optional<double> ground_height_m;  ///< tissue is held above y = this height; no value: no ground
  bool ground_reaction_known = false;     ///< whether states have a ground reaction

  /// Numbers of surface vertices and faces of all bodies, and of nodes of all tools: the lengths of the
  /// arrays of a State.
  int vertexCount() const {
    return bodies.empty()
               ? 0
               : bodies.back().first_vertex + static_cast<int>(bodies.back().rest.vertices_m.size());
  }
  int faceCount() const {
    return bodies.empty() ? 0 : bodies.back().first_face + static_cast<int>(bodies.back().rest.faces.size());
  }
  /// Whether any clamp has parts that are drawn beside its jaws.
  bool hasHandles() const {
    return std::any_of(clamps.begin(), clamps.end(),
                       [](const SceneClamp& c) { return !c.handle.faces.empty(); });
  }
  int nodeCount() const { return tools.empty() ? 0 : tools.back().first_node + tools.back().nodes.size(); }
};

}  // namespace fissure
