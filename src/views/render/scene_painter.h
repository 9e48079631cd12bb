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

/// Draws ground, tissue and tools with OpenGL; holds all that does not change between frames.
///
/// The colour of an elastic body is darker where contacts press on it, relative to the largest pressure in
/// the picture. Tissue and tools are opaque. The part of a tool behind or inside tissue shows as a faint tint
/// with a dashed outline, and a dark red line marks the intersection of the two surfaces: a tool behind the
/// tissue has no such line, one that passes through it has one on each side.
class ScenePainter {
 public:
  /// `first` determines the visible part of the ground. line_px: width of a thin line in pixels of the OpenGL
  /// picture.
  ScenePainter(const Scene& scene, const State& first, const Camera& camera, double line_px);

  /// Clears the current picture and depth buffer of `gl` and draws the scene. The arrays of `state` must fit
  /// the scene.
  void paint(const GlFunctions& gl, const State& state) const;

 private:
  struct Body {
    Surface surface;
    int first_vertex = 0;
    int vertex_count = 0;
    Colour colour;
  };
  /// Colours of the two sides of a surface, and the angle between faces above which an edge is drawn sharp.
  struct Look {
    Colour outside;
    Colour inside;
    double crease_deg = 0;
    /// [vertex] pressure over the largest one in the picture, 0 to 1; empty: no pressure.
    std::span<const double> pressed = {};

    Colour outsideAt(int vertex) const;
  };
  /// The vertices of one surface in one state, ready to be drawn.
  struct Placed {
    VertexBatch front;    ///< triangles, lit from outside
    VertexBatch back;     ///< the same seen from behind
    VertexBatch edges;    ///< lines
    VertexBatch outline;  ///< lines: silhouette, and for tools the visible sharp edges
  };

  Placed placeBody(const Body& body, std::span<const Vec3> vertices_m, std::span<const double> pressed) const;
  Placed placeTool(const Surface& surface, const std::vector<Vec3>& vertices_m) const;
  void addTriangles(Placed& placed, const Surface& surface, std::span<const Vec3> vertices_m,
                    const Look& look) const;
  bool facesCamera(const Surface& surface, std::span<const Vec3> vertices_m, const std::vector<Vec3>& normals,
                   int face) const;
  Colour lit(Colour base, const Vec3& normal) const;
  /// Opacity of mesh edges, which fade where they would be closer together than a few pixels.
  double edgeStrength(const Surface& surface, std::span<const Vec3> vertices_m) const;

  void setUp(const GlFunctions& gl) const;
  void drawGround(const GlFunctions& gl, const std::vector<Placed>& bodies,
                  const std::vector<Placed>& tools) const;
  void drawSurface(const GlFunctions& gl, const Placed& placed) const;
  void drawHidden(const GlFunctions& gl, const Placed& tool) const;
  /// Handles of clamps, drawn like tools but without intersection lines.
  std::vector<Placed> placeHandles(const State& state) const;
  VertexBatch cutLines(const std::vector<std::vector<Vec3>>& tools_m, const State& state) const;

  Camera camera_;
  double line_px_ = 1;
  std::vector<Body> bodies_;
  std::vector<Surface> tools_;
  std::vector<std::vector<Vec3>> tool_vertices_m_;    ///< in each tool's frame
  std::vector<Surface> handles_;                      ///< one per clamp
  std::vector<std::vector<Vec3>> handle_vertices_m_;  ///< in each clamp's frame
  std::optional<double> ground_height_m_;
  GroundPlane ground_;
};

}  // namespace fissure
