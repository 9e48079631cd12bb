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
  std::vector<int> vertices;  ///< of its body, at least one
};

/// The inside of an elastic body as placed at time zero.
struct SceneVolume {
  TetrahedralMesh mesh;             ///< in the scene's frame; its first vertices are the body's surface
  std::vector<int> fixed_vertices;  ///< of the mesh, ascending: they never move
  /// One a tetrahedron: 0, or 1 + the index of its region in the body's settings; empty: there are none.
  std::vector<int> regions = {};
};

/// A soft body as placed at time zero.
struct SceneBody {
  std::string name;
  TriangleMesh
      rest;  ///< in the scene's frame; closed, outward faces; indices count from this body's first vertex
  int first_vertex = 0;  ///< of this body in the concatenated vertex arrays of a State
  int first_face = 0;
  std::vector<int> fixed_vertices = {};  ///< of this body, ascending: they never move
  std::vector<Gauge> gauges = {};
  std::optional<SceneVolume> volume = {};  ///< of an elastic body
  std::vector<std::string> repairs;        ///< what was repaired of its file's surface, a line each
};

/// A rigid, kinematic tool, in its own frame.
struct SceneTool {
  std::string name;
  TriangleMesh surface;                   ///< outward faces
  std::optional<Vec3> box_size_m;         ///< full edge lengths when the tool is a box centred on its origin
  bool closed = true;                     ///< false: the surface has no inside
  ToolNodes nodes;                        ///< empty for pipelines that use none
  int first_node = 0;                     ///< of this tool in the concatenated node arrays of a State
  std::vector<std::string> repairs = {};  ///< as a body's
};

/// Two tools that are the jaws of a clamp.
struct SceneClamp {
  std::string name;
  int left_tool = 0;  ///< index in Scene::tools
  int right_tool = 0;
  bool hinged = false;  ///< its opening is an angle, degrees; else the way between the jaws, metres
  TriangleMesh handle;  ///< in the clamp's frame, to be drawn; empty where nothing is drawn
};

/// The geometry of one run: what engine, measure, render and store agree on. Built once from a scenario.
struct Scene {
  std::vector<SceneBody> bodies;
  std::vector<SceneTool> tools;
  std::vector<SceneClamp> clamps;
  std::optional<double> ground_height_m;  ///< tissue is held above y = this height; no value: no ground
  bool ground_reaction_known = false;     ///< whether states say what the ground bears

  int vertexCount() const {
    return bodies.empty()
               ? 0
               : bodies.back().first_vertex + static_cast<int>(bodies.back().rest.vertices_m.size());
  }
  int faceCount() const {
    return bodies.empty() ? 0 : bodies.back().first_face + static_cast<int>(bodies.back().rest.faces.size());
  }
  /// Whether a clamp has anything to be drawn beside its jaws.
  bool hasHandles() const {
    return std::any_of(clamps.begin(), clamps.end(),
                       [](const SceneClamp& c) { return !c.handle.faces.empty(); });
  }
  int nodeCount() const { return tools.empty() ? 0 : tools.back().first_node + tools.back().nodes.size(); }
};

}  // namespace fissure
