#include "render/overlay.h"

#include <algorithm>
#include <cmath>

#include "render/font.h"

namespace fissure {
namespace {

constexpr double margin_units = 6;
constexpr Colour veil{255, 255, 255, 190};  ///< lifts text off what is behind it

struct NodeDot {
  PicturePoint at;
  NodeState state = NodeState::free;
  bool hidden = false;
};

/// The pixel of the OpenGL picture in which a dot lies, counted from bottom left, which may be outside of it.
struct Pixel {
  double column, row;
};

Pixel pixelOf(const PicturePoint& at, const Camera& camera, int scale) {
  return {std::floor(at.x_px * scale), camera.height_px * scale - 1 - std::floor(at.y_px * scale)};
}

bool isInPicture(const Pixel& pixel, const Camera& camera, int scale) {
  return pixel.column >= 0 && pixel.column < camera.width_px * scale && pixel.row >= 0 &&
         pixel.row < camera.height_px * scale;
}

/// The dots whose nodes can be seen or hidden: those in the picture; others keep `hidden` false.
void findHidden(std::vector<NodeDot>& dots, const Camera& camera, const DepthPicture& depths) {
  Eigen::AlignedBox2i box;
  for (const NodeDot& dot : dots)
    if (const Pixel pixel = pixelOf(dot.at, camera, depths.scale); isInPicture(pixel, camera, depths.scale))
      box.extend(Eigen::Vector2i(static_cast<int>(pixel.column), static_cast<int>(pixel.row)));
  if (box.isEmpty()) return;
  const PixelRectangle part{box.min().x(), box.min().y(), box.sizes().x() + 1, box.sizes().y() + 1};
  const std::vector<float> stored = depths.read(part);
  for (NodeDot& dot : dots) {
    const Pixel pixel = pixelOf(dot.at, camera, depths.scale);
    if (!isInPicture(pixel, camera, depths.scale)) continue;
    const auto column = static_cast<std::size_t>(pixel.column) - static_cast<std::size_t>(part.left);
    const auto row = static_cast<std::size_t>(pixel.row) - static_cast<std::size_t>(part.bottom);
    const double depth_m =
        camera.depthFromStored(stored[row * static_cast<std::size_t>(part.columns) + column]);
    // The node lies on the tool's own surface: a slack of 1/400 covers that surface's slope within a pixel.
    dot.hidden = dot.at.depth_m > depth_m * (1 + 1.0 / 400);
  }
}

std::string lengthLabel(double length_m) {
  const bool metres = length_m >= 0.9995;
  const double shown = metres ? length_m : length_m * 1000;
  std::string text = std::to_string(shown);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text + (metres ? " m" : " mm");
}

}  // namespace

void drawLines(Image& image, const std::vector<std::string>& lines) {
  double unit_px = font::unitFor(image.height_px);
  const auto widest_px = [&] {
    double widest = 0;
    for (const std::string& line : lines) {
      widest = std::max(widest, font::textWidth_px(line, unit_px));
    }
    return widest;
  };
  while (unit_px > 1 && widest_px() + 2 * margin_units * unit_px > image.width_px) {
    unit_px -= 0.5;
  }
  const Point2 corner_px = Point2::Constant(margin_units * unit_px);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double base_px = corner_px.y() + (6 + static_cast<double>(i) * font::line_units) * unit_px;
    const double width_px = font::textWidth_px(lines[i], unit_px);
    if (width_px > 0) {
      fillRectangle(image, {corner_px.x() - 2 * unit_px, base_px - 8 * unit_px},
                    {corner_px.x() + width_px + 2 * unit_px, base_px + 3 * unit_px}, veil);
    }
    font::drawText(image, {corner_px.x(), base_px}, lines[i], unit_px, palette::ink);
  }
}

double scaleBarLength_m(const Camera& camera) {
  const double pixel_m = camera.pixelSize_m(camera.focus_m);
  const double shortest_m = camera.width_px / 24.0 * pixel_m;
  if (0.01 >= shortest_m && 0.01 <= camera.width_px / 3.0 * pixel_m) {
    return 0.01;
  }
  const double decade_m = std::pow(10, std::floor(std::log10(shortest_m)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade_m >= shortest_m) {
      return factor * decade_m;
    }
  }
  return 10 * decade_m;
}

void drawScaleBar(Image& image, const Camera& camera) {
  const double unit_px = font::unitFor(image.height_px);
  const double length_m = scaleBarLength_m(camera);
  const double length_px = length_m / camera.pixelSize_m(camera.focus_m);
  const std::string label = lengthLabel(length_m);
  const double label_px = font::textWidth_px(label, unit_px);
  const double needed_px = std::max(length_px, label_px) + 2 * margin_units * unit_px;
  if (needed_px > image.width_px / 2.0 || 4 * font::line_units * unit_px > image.height_px) {
    return;
  }
  const double y_px = std::floor(image.height_px - margin_units * unit_px) + 0.5;
  const double right_px = std::floor(image.width_px - margin_units * unit_px) + 0.5;
  const double left_px = right_px - length_px;
  const double width_px = std::max(1.0, 1.3 * unit_px);
  drawStroke(image, {left_px, y_px}, {right_px, y_px}, width_px, palette::ink);
  for (const double x_px : {left_px, right_px}) {
    drawStroke(image, {x_px, y_px - 2 * unit_px}, {x_px, y_px + 2 * unit_px}, width_px, palette::ink);
  }
  const double label_left_px = std::min((left_px + right_px - label_px) / 2, right_px - label_px);
  font::drawText(image, {label_left_px, y_px - 4 * unit_px}, label, unit_px, palette::ink);
}

void drawNodeLegend(Image& image) {
  const double unit_px = font::unitFor(image.height_px);
  const double height_px = static_cast<double>(palette::nodes.size()) * font::line_units * unit_px;
  const double widest_px = font::textWidth_px("infeasible", unit_px) + 8 * unit_px;
  if (2 * widest_px > image.width_px || 2 * height_px > image.height_px) {
    return;
  }
  const double left_px = margin_units * unit_px;
  for (std::size_t i = 0; i < palette::nodes.size(); ++i) {
    const double rows_below = static_cast<double>(palette::nodes.size() - 1 - i);
    const double base_px = image.height_px - (margin_units - 2 + rows_below * font::line_units) * unit_px;
    drawDisc(image, {left_px + 2 * unit_px, base_px - 2.5 * unit_px}, 2.6 * unit_px, palette::nodes[i]);
    font::drawText(image, {left_px + 8 * unit_px, base_px}, palette::node_names[i], unit_px, palette::ink);
  }
}

void drawNodes(Image& image, const Camera& camera, const Scene& scene, const State& state,
               const DepthPicture& depths) {
  std::vector<NodeDot> dots;
  for (std::size_t tool = 0; tool < scene.tools.size(); ++tool) {
    const ToolNodes& nodes = scene.tools[tool].nodes;
    for (int i = 0; i < nodes.size(); ++i) {
      const std::size_t index = static_cast<std::size_t>(scene.tools[tool].first_node) + i;
      const Vec3 placed_m = state.tools[tool].pose.toScene(nodes.positions_m[i]);
      const auto at = drawable(placed_m) ? camera.project(placed_m) : std::nullopt;
      if (at && index < state.contact.node_states.size()) {
        dots.push_back({*at, state.contact.node_states[index]});
      }
    }
  }
  findHidden(dots, camera, depths);
  std::stable_sort(dots.begin(), dots.end(),
                   [](const NodeDot& a, const NodeDot& b) { return a.at.depth_m > b.at.depth_m; });
  const double unit_px = font::unitFor(image.height_px);
  const Colour rim{255, 255, 255, 200};
  for (const NodeDot& dot : dots) {
    const Point2 centre_px(dot.at.x_px, dot.at.y_px);
    const Colour colour = palette::ofNode(dot.state);
    if (dot.state == NodeState::free) {
      if (!dot.hidden) {
        drawDisc(image, centre_px, 1.0 * unit_px, colour);
      }
    } else if (dot.hidden) {
      drawDisc(image, centre_px, 1.5 * unit_px, colour);
      drawDisc(image, centre_px, 0.7 * unit_px, rim);
    } else {
      drawDisc(image, centre_px, 2.4 * unit_px, rim);
      drawDisc(image, centre_px, 1.9 * unit_px, colour);
    }
  }
}

}  // namespace fissure
