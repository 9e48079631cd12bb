#include "render/offscreen_renderer.h"

#include <fmt/core.h>

#include "base/error.h"
#include "render/overlay.h"
#include "render/scene_painter.h"

namespace fissure {
namespace {

/// OSMesa has no multisampling: pictures up to full HD are drawn twice as fine and averaged. Beyond that,
/// pixels are fine enough, and memory dear.
int supersampling(int width_px, int height_px) {
  return width_px * height_px <= 1920 * 1088 ? 2 : 1;
}

/// Thin lines keep their share of the picture.
double lineWidth_px(int height_px) {
  return std::max(1.0, height_px / 600.0);
}

class OffscreenRenderer : public FrameSource {
 public:
  OffscreenRenderer(const Scene& scene, const Camera& camera, const State& first)
      : scene_(scene),
        camera_(camera),
        scale_(supersampling(camera.width_px, camera.height_px)),
        painter_(scene, first, camera_, scale_ * lineWidth_px(camera.height_px)),
        mesa_(scale_ * camera.width_px, scale_ * camera.height_px) {}

  Image draw(const State& state, const std::vector<std::string>& lines) override {
    if (state.positions_m.size() != static_cast<std::size_t>(scene_.vertexCount()) ||
        state.tools.size() != scene_.tools.size() || state.clamps.size() != scene_.clamps.size()) {
      throw RunError(
          fmt::format("frames: a state of {} vertices and {} tools, {} clamps does not fit the scene",
                      state.positions_m.size(), state.tools.size(), state.clamps.size()));
    }
    mesa_.makeCurrent();
    mesa_.gl().viewport(0, 0, mesa_.width_px(), mesa_.height_px());
    painter_.paint(mesa_.gl(), state);
    Image image = downsample(mesa_.finishedPicture(), camera_.width_px, camera_.height_px, scale_);
    if (!state.contact.node_states.empty()) {
      const auto depths = [&](const PixelRectangle& part) { return mesa_.depths(part); };
      drawNodes(image, camera_, scene_, state, {depths, scale_});
      drawNodeLegend(image);
    }
    drawScaleBar(image, camera_);
    drawLines(image, lines);
    return image;
  }

  std::vector<std::pair<std::string, std::string>> versions() const override {
    return {{"gl_version", mesa_.version()}, {"gl_renderer", mesa_.renderer()}};
  }

 private:
  Scene scene_;
  Camera camera_;
  int scale_ = 1;
  ScenePainter painter_;
  OsMesa mesa_;
};

}  // namespace

std::unique_ptr<FrameSource> makeOffscreenRenderer(const Scene& scene, const FrameSettings& settings,
                                                   const State& first) {
  return makeOffscreenRenderer(scene, frameCamera(settings, pointsInView(scene, first)), first);
}

std::unique_ptr<FrameSource> makeOffscreenRenderer(const Scene& scene, const Camera& camera,
                                                   const State& first) {
  return std::make_unique<OffscreenRenderer>(scene, camera, first);
}

}  // namespace fissure
