#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "render/camera.h"
#include "render/ground.h"
#include "render/osmesa.h"
#include "render/surface.h"

namespace fissure {

/// Draws ground, tissue and tools with OpenGL; holds what stays the same from frame to frame.
///
/// An elastic body is the darker the more its contacts press it, against the largest pressure in the picture.
/// Tissue and tools are opaque, so what is seen is in front. A tool's part behind or inside tissue shows
/// through as a faint tint with a dashed outline, and a dark red line marks where the two surfaces cross: a
/// tool that is behind the tissue has no such line, one that passes through has one at each side.
class ScenePainter {
 public:
  /// `first` says where the ground is. line_px: width of a thin line in pixels of the OpenGL picture.
  ScenePainter(const Scene& scene, const State& first, const Camera& camera, double line_px);

  /// Clears the current picture of gl and draws the scene, with its depths. The sizes of `state` fit the
  /// scene.
  void paint(const GlFunctions& gl, const State& state) const;

 private:
  struct Body {
    Surface surface;
    int first_vertex = 0;
    int vertex_count = 0;
    Colour colour;
  };
  /// Colours of a surface seen from either side, and the angle between faces from which an edge looks sharp.
  struct Look {
    Colour outside;
    Colour inside;
    double crease_deg = 0;
    /// One per vertex: how far its outside is pressed, 0 to 1; empty: nowhere.
    std::span<const double> pressed = {};

    Colour outsideAt(int vertex) const;
  };
  /// One surface in one state; drawn from these alone.
  struct Placed {
    VertexBatch front;    ///< triangles, lit from outside
    VertexBatch back;     ///< the same seen from behind
    VertexBatch edges;    ///< lines
    VertexBatch outline;  ///< lines: silhouette, and for tools the sharp edges in view
  };

  Placed placeBody(const Body& body, std::span<const Vec3> vertices_m, std::span<const double> pressed) const;
  Placed placeTool(const Surface& surface, const std::vector<Vec3>& vertices_m) const;
  void addTriangles(Placed& placed, const Surface& surface, std::span<const Vec3> vertices_m,
                    const Look& look) const;
  bool facesCamera(const Surface& surface, std::span<const Vec3> vertices_m, const std::vector<Vec3>& normals,
                   int face) const;
  Colour lit(Colour base, const Vec3& normal) const;
  /// How strongly mesh edges are drawn: they fade where they would be closer than a few pixels.
  double edgeStrength(const Surface& surface, std::span<const Vec3> vertices_m) const;

  void setUp(const GlFunctions& gl) const;
  void drawGround(const GlFunctions& gl, const std::vector<Placed>& bodies,
                  const std::vector<Placed>& tools) const;
  void drawSurface(const GlFunctions& gl, const Placed& placed) const;
  void drawHidden(const GlFunctions& gl, const Placed& tool) const;
  /// Handles of clamps: as tools, but they cross nothing.
  std::vector<Placed> placeHandles(const State& state) const;
  VertexBatch cutLines(const std::vector<std::vector<Vec3>>& tools_m, const State& state) const;

  Camera camera_;
  double line_px_ = 1;
  std::vector<Body> bodies_;
  std::vector<Surface> tools_;
  std::vector<std::vector<Vec3>> tool_vertices_m_;    ///< in each tool's frame
  std::vector<Surface> handles_;                      ///< one a clamp
  std::vector<std::vector<Vec3>> handle_vertices_m_;  ///< in each clamp's frame
  std::optional<double> ground_height_m_;
  GroundPlane ground_;
};

}  // namespace fissure
