#include "render/scene_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fissure {
namespace {

constexpr double tissue_crease_deg = 50;
constexpr double tool_crease_deg = 30;
constexpr double shadow_far =
    0.18;  ///< darkness of a shadow cast from far above, as a share of one at contact
constexpr double shadow_fade_m = 0.008;  ///< height over which it fades to that

/// The pressure at each vertex of an elastic body as a share of the largest, 0 where the vertex is pulled;
/// empty where nothing is pressed.
std::vector<double> sharesOfLargest(const State& state) {
  if (!state.volume || state.volume->pressures_Pa.empty()) return {};
  std::vector<double> shares = state.volume->pressures_Pa;
  const double largest_Pa = *std::max_element(shares.begin(), shares.end());
  if (!(largest_Pa > 0)) return {};
  for (double& share : shares) share = share > 0 ? std::min(share / largest_Pa, 1.0) : 0;  // NaN is not
  return shares;
}

void draw(const GlFunctions& gl, GLenum mode, const VertexBatch& batch) {
  if (batch.size() > 0) {
    gl.vertexPointer(3, GL_FLOAT, 0, batch.xyz_m.data());
    gl.colorPointer(4, GL_UNSIGNED_BYTE, 0, batch.rgba.data());
    gl.drawArrays(mode, 0, batch.size());
  }
}

VertexBatch recoloured(const VertexBatch& batch, Colour colour) {
  VertexBatch copy;
  copy.xyz_m = batch.xyz_m;
  for (int i = 0; i < batch.size(); ++i) {
    copy.rgba.insert(copy.rgba.end(), {colour.r, colour.g, colour.b, colour.a});
  }
  return copy;
}

/// Triangles cast straight down, darker where they are close to the ground: shows how high above it a thing
/// is.
VertexBatch shadowOf(const VertexBatch& triangles, double ground_height_m) {
  VertexBatch shadow = triangles;
  for (std::size_t i = 0; i < static_cast<std::size_t>(triangles.size()); ++i) {
    const double height_m = std::max(0.0, triangles.xyz_m[3 * i + 1] - ground_height_m);
    const double share = shadow_far + (1 - shadow_far) * std::exp(-height_m / shadow_fade_m);
    const auto mix = [&](std::uint8_t lit, std::uint8_t dark) {
      return static_cast<std::uint8_t>(std::lround(lit + share * (dark - lit)));
    };
    shadow.xyz_m[3 * i + 1] = static_cast<float>(ground_height_m);
    shadow.rgba[4 * i] = mix(palette::ground.r, palette::ground_shadow.r);
    shadow.rgba[4 * i + 1] = mix(palette::ground.g, palette::ground_shadow.g);
    shadow.rgba[4 * i + 2] = mix(palette::ground.b, palette::ground_shadow.b);
  }
  return shadow;
}

}  // namespace

ScenePainter::ScenePainter(const Scene& scene, const State& first, const Camera& camera, double line_px)
    : camera_(camera), line_px_(line_px), ground_height_m_(scene.ground_height_m) {
  for (const SceneBody& body : scene.bodies) {
    const int count = static_cast<int>(body.rest.vertices_m.size());
    bodies_.push_back({Surface(body.rest.faces, count), body.first_vertex, count,
                       palette::tissue[bodies_.size() % palette::tissue.size()]});
  }
  for (const SceneTool& tool : scene.tools) {
    tools_.emplace_back(tool.surface.faces, static_cast<int>(tool.surface.vertices_m.size()));
    tool_vertices_m_.push_back(tool.surface.vertices_m);
  }
  for (const SceneClamp& clamp : scene.clamps) {
    handles_.emplace_back(clamp.handle.faces, static_cast<int>(clamp.handle.vertices_m.size()));
    handle_vertices_m_.push_back(clamp.handle.vertices_m);
  }
  if (ground_height_m_) {
    ground_ = makeGroundPlane(pointsInView(scene, first), *ground_height_m_);
  }
}

Colour ScenePainter::lit(Colour base, const Vec3& normal) const {
  // A lamp above the camera's left shoulder; half Lambert keeps the far side readable.
  const Vec3 lamp = (-0.45 * camera_.right + 0.75 * camera_.up + 0.6 * camera_.back).normalized();
  const double facing = 0.5 + 0.5 * normal.dot(lamp);
  const double brightness = 0.50 + 0.58 * std::pow(facing, 1.5);
  const auto scaled = [&](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(std::min(255.0, channel * brightness)));
  };
  return {scaled(base.r), scaled(base.g), scaled(base.b)};
}

Colour ScenePainter::Look::outsideAt(int vertex) const {
  if (pressed.empty()) return outside;
  const double share = pressed[vertex];
  const auto mixed = [share](std::uint8_t free, std::uint8_t full) {
    return static_cast<std::uint8_t>(std::lround(free + share * (full - free)));
  };
  const Colour& full = palette::tissue_pressed;
  return {mixed(outside.r, full.r), mixed(outside.g, full.g), mixed(outside.b, full.b)};
}

void ScenePainter::addTriangles(Placed& placed, const Surface& surface, std::span<const Vec3> vertices_m,
                                const Look& look) const {
  const std::vector<std::array<Vec3, 3>> normals = surface.cornerNormals(vertices_m, look.crease_deg);
  for (int face = 0; face < static_cast<int>(surface.faces().size()); ++face) {
    if (!surface.faceDrawable(vertices_m, face)) {
      continue;
    }
    for (int corner = 0; corner < 3; ++corner) {
      const int vertex = surface.faces()[face][corner];
      const Vec3& vertex_m = vertices_m[vertex];
      placed.front.add(vertex_m, lit(look.outsideAt(vertex), normals[face][corner]));
      placed.back.add(vertex_m, lit(look.inside, -normals[face][corner]));
    }
  }
}

bool ScenePainter::facesCamera(const Surface& surface, std::span<const Vec3> vertices_m,
                               const std::vector<Vec3>& normals, int face) const {
  return face >= 0 && normals[face].dot(camera_.position_m - vertices_m[surface.faces()[face][0]]) > 0;
}

double ScenePainter::edgeStrength(const Surface& surface, std::span<const Vec3> vertices_m) const {
  double sum_px = 0;
  int counted = 0;
  for (const SurfaceEdge& edge : surface.edges()) {
    const auto a = camera_.project(vertices_m[edge.a]);
    const auto b = camera_.project(vertices_m[edge.b]);
    if (a && b) {
      sum_px += std::hypot(a->x_px - b->x_px, a->y_px - b->y_px);
      ++counted;
    }
  }
  return counted > 0 ? std::clamp((sum_px / counted - 2) / 12, 0.0, 1.0) : 0.0;
}

ScenePainter::Placed ScenePainter::placeBody(const Body& body, std::span<const Vec3> vertices_m,
                                             std::span<const double> pressed) const {
  Placed placed;
  addTriangles(placed, body.surface, vertices_m,
               {body.colour, palette::tissue_inside, tissue_crease_deg, pressed});
  const std::vector<Vec3> normals = body.surface.faceNormals(vertices_m);
  Colour edge_colour = palette::tissue_edge;
  edge_colour.a = static_cast<std::uint8_t>(edge_colour.a * edgeStrength(body.surface, vertices_m));
  for (const SurfaceEdge& edge : body.surface.edges()) {
    if (!drawable(vertices_m[edge.a]) || !drawable(vertices_m[edge.b])) {
      continue;
    }
    const bool silhouette = facesCamera(body.surface, vertices_m, normals, edge.face_a) !=
                            facesCamera(body.surface, vertices_m, normals, edge.face_b);
    VertexBatch& lines = silhouette ? placed.outline : placed.edges;
    lines.add(vertices_m[edge.a], silhouette ? palette::tissue_outline : edge_colour);
    lines.add(vertices_m[edge.b], silhouette ? palette::tissue_outline : edge_colour);
  }
  return placed;
}

ScenePainter::Placed ScenePainter::placeTool(const Surface& surface,
                                             const std::vector<Vec3>& vertices_m) const {
  Placed placed;
  addTriangles(placed, surface, vertices_m, {palette::steel, palette::steel_edge, tool_crease_deg});
  const std::vector<Vec3> normals = surface.faceNormals(vertices_m);
  const double flat_cosine = std::cos(tool_crease_deg * std::numbers::pi / 180);
  for (const SurfaceEdge& edge : surface.edges()) {
    const bool in_view = facesCamera(surface, vertices_m, normals, edge.face_a) ||
                         facesCamera(surface, vertices_m, normals, edge.face_b);
    const bool silhouette = facesCamera(surface, vertices_m, normals, edge.face_a) !=
                            facesCamera(surface, vertices_m, normals, edge.face_b);
    const bool sharp = edge.face_b < 0 || normals[edge.face_a].dot(normals[edge.face_b]) < flat_cosine;
    if (in_view && (silhouette || sharp) && drawable(vertices_m[edge.a]) && drawable(vertices_m[edge.b])) {
      placed.outline.add(vertices_m[edge.a], palette::steel_edge);
      placed.outline.add(vertices_m[edge.b], palette::steel_edge);
    }
  }
  return placed;
}

void ScenePainter::setUp(const GlFunctions& gl) const {
  const auto channel = [](std::uint8_t value) { return static_cast<float>(value) / 255; };
  gl.clearColor(channel(palette::background.r), channel(palette::background.g),
                channel(palette::background.b), 1);
  gl.depthMask(GL_TRUE);
  gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.matrixMode(GL_PROJECTION);
  gl.loadMatrixd(camera_.projectionMatrix().data());
  gl.matrixMode(GL_MODELVIEW);
  gl.loadMatrixd(camera_.viewMatrix().data());
  gl.enableClientState(GL_VERTEX_ARRAY);
  gl.enableClientState(GL_COLOR_ARRAY);
  gl.enable(GL_DEPTH_TEST);
  gl.depthFunc(GL_LEQUAL);
  gl.enable(GL_BLEND);
  gl.blendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.disable(GL_DITHER);
  // Fills step back a little, so that lines on them are not half buried.
  gl.enable(GL_POLYGON_OFFSET_FILL);
  gl.polygonOffset(1, 1);
}

void ScenePainter::drawGround(const GlFunctions& gl, const std::vector<Placed>& bodies,
                              const std::vector<Placed>& tools) const {
  if (!ground_height_m_ || camera_.position_m.y() <= *ground_height_m_) {
    return;  // seen from below it would hide the scene
  }
  gl.polygonOffset(2, 2);
  gl.disable(GL_BLEND);
  draw(gl, GL_TRIANGLES, ground_.fill);
  gl.enable(GL_BLEND);
  gl.depthMask(GL_FALSE);
  gl.polygonOffset(1, 1);
  gl.blendEquation(GL_MIN);  // of overlapping shadows the darkest holds
  for (const Placed& body : bodies) {
    draw(gl, GL_TRIANGLES, shadowOf(body.front, *ground_height_m_));
  }
  for (const Placed& tool : tools) {
    draw(gl, GL_TRIANGLES, shadowOf(tool.front, *ground_height_m_));
  }
  gl.blendEquation(GL_FUNC_ADD);
  gl.lineWidth(static_cast<float>(line_px_));
  draw(gl, GL_LINES, ground_.grid);
  gl.depthMask(GL_TRUE);
}

void ScenePainter::drawSurface(const GlFunctions& gl, const Placed& placed) const {
  gl.disable(GL_BLEND);  // the same picture for what is opaque, and cheaper
  gl.enable(GL_CULL_FACE);
  gl.cullFace(GL_BACK);
  draw(gl, GL_TRIANGLES, placed.front);
  gl.cullFace(GL_FRONT);
  draw(gl, GL_TRIANGLES, placed.back);
  gl.disable(GL_CULL_FACE);
  gl.enable(GL_BLEND);
  gl.depthMask(GL_FALSE);
  gl.lineWidth(static_cast<float>(line_px_));
  draw(gl, GL_LINES, placed.edges);
  gl.lineWidth(static_cast<float>(1.4 * line_px_));
  draw(gl, GL_LINES, placed.outline);
  gl.depthMask(GL_TRUE);
}

void ScenePainter::drawHidden(const GlFunctions& gl, const Placed& tool) const {
  // Only tissue and ground are drawn by now: what is farther than they are, is hidden by them and not by the
  // tool.
  gl.depthFunc(GL_GREATER);
  gl.depthMask(GL_FALSE);
  gl.enable(GL_CULL_FACE);
  gl.cullFace(GL_BACK);
  draw(gl, GL_TRIANGLES, recoloured(tool.front, palette::hidden_tint));
  gl.disable(GL_CULL_FACE);
  gl.enable(GL_LINE_STIPPLE);
  gl.lineStipple(static_cast<GLint>(std::lround(std::max(1.0, line_px_))), 0x1F1F);
  gl.lineWidth(static_cast<float>(1.2 * line_px_));
  draw(gl, GL_LINES, recoloured(tool.outline, palette::hidden_line));
  gl.disable(GL_LINE_STIPPLE);
  gl.depthMask(GL_TRUE);
  gl.depthFunc(GL_LEQUAL);
}

VertexBatch ScenePainter::cutLines(const std::vector<std::vector<Vec3>>& tools_m, const State& state) const {
  VertexBatch lines;
  for (const Body& body : bodies_) {
    const std::span<const Vec3> vertices_m(state.positions_m.data() + body.first_vertex, body.vertex_count);
    for (std::size_t tool = 0; tool < tools_.size(); ++tool) {
      const auto segments =
          cutSegments(tools_[tool].faces(), tools_m[tool], body.surface.faces(), vertices_m);
      for (const auto& [from_m, to_m] : segments) {
        // Towards the camera by a thousandth of the distance, or both surfaces would hide half of it.
        lines.add(from_m + 0.001 * (camera_.position_m - from_m), palette::cut);
        lines.add(to_m + 0.001 * (camera_.position_m - to_m), palette::cut);
      }
    }
  }
  return lines;
}

std::vector<ScenePainter::Placed> ScenePainter::placeHandles(const State& state) const {
  std::vector<Placed> handles;
  for (std::size_t clamp = 0; clamp < handles_.size(); ++clamp) {
    std::vector<Vec3> vertices_m = handle_vertices_m_[clamp];
    for (Vec3& vertex_m : vertices_m) {
      vertex_m = state.clamps[clamp].pose.toScene(vertex_m);
    }
    handles.push_back(placeTool(handles_[clamp], vertices_m));
  }
  return handles;
}

void ScenePainter::paint(const GlFunctions& gl, const State& state) const {
  const std::vector<double> pressed = sharesOfLargest(state);
  std::vector<Placed> bodies;
  for (const Body& body : bodies_) {
    const auto first = static_cast<std::size_t>(body.first_vertex);
    const auto count = static_cast<std::size_t>(body.vertex_count);
    bodies.push_back(
        placeBody(body, std::span(state.positions_m).subspan(first, count),
                  pressed.empty() ? std::span<const double>() : std::span(pressed).subspan(first, count)));
  }
  std::vector<Placed> tools;
  std::vector<std::vector<Vec3>> tools_m = tool_vertices_m_;
  for (std::size_t tool = 0; tool < tools_.size(); ++tool) {
    for (Vec3& vertex_m : tools_m[tool]) {
      vertex_m = state.tools[tool].pose.toScene(vertex_m);
    }
    tools.push_back(placeTool(tools_[tool], tools_m[tool]));
  }
  for (Placed& handle : placeHandles(state)) {
    tools.push_back(std::move(handle));
  }

  setUp(gl);
  drawGround(gl, bodies, tools);
  for (const Placed& body : bodies) {
    drawSurface(gl, body);
  }
  for (const Placed& tool : tools) {
    drawHidden(gl, tool);
  }
  const VertexBatch cut = cutLines(tools_m, state);
  gl.lineWidth(static_cast<float>(1.8 * line_px_));
  gl.depthFunc(GL_GREATER);
  gl.depthMask(GL_FALSE);
  draw(gl, GL_LINES, recoloured(cut, palette::hidden_cut));
  gl.depthMask(GL_TRUE);
  gl.depthFunc(GL_LEQUAL);
  for (const Placed& tool : tools) {
    drawSurface(gl, tool);
  }
  gl.lineWidth(static_cast<float>(1.8 * line_px_));
  draw(gl, GL_LINES, cut);
}

}  // namespace fissure
