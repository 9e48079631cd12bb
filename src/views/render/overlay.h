#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "render/camera.h"
#include "render/canvas.h"

namespace fissure {

/// What is written over a finished picture. All keep clear of each other and leave out what does not fit.

/// Lines of text in the top left corner, in letters as large as the width allows.
void drawLines(Image& image, const std::vector<std::string>& lines);

/// A bar in the bottom right corner that is 10 mm long at the camera's focus; where 10 mm would be under 1/24
/// or over a third of the width, the nearest 1, 2 or 5 times a power of ten that is not.
void drawScaleBar(Image& image, const Camera& camera);

/// The length that drawScaleBar shows, metres.
double scaleBarLength_m(const Camera& camera);

/// The colours of the node states, in the bottom left corner.
void drawNodeLegend(Image& image);

/// Depth of the nearest surface in a pixel of the OpenGL picture, which is `scale` times as fine as the
/// camera's.
struct DepthPicture {
  std::span<const float> stored;  ///< rows from bottom to top, 0 (near) to 1 (far)
  int scale = 1;
};

/// Tool nodes as dots in the colours of their states, far ones first. A free node is drawn where it is in
/// view; the others always: filled where in view, as a ring where something hides them. Nodes without a state
/// are left out.
void drawNodes(Image& image, const Camera& camera, const Scene& scene, const State& state,
               const DepthPicture& depths);

}  // namespace fissure
