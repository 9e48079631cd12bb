#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "render/camera.h"
#include "render/canvas.h"

namespace fissure {

/// Overlays on a finished picture. They leave out what does not fit, and do not overlap each other.

/// Draws lines of text in the top left corner, in letters as large as the width allows.
void drawLines(Image& image, const std::vector<std::string>& lines);

/// Draws a bar of scaleBarLength_m() at the camera's focus in the bottom right corner.
void drawScaleBar(Image& image, const Camera& camera);

/// Length of the scale bar, metres: 10 mm, or, where that would be less than 1/24 or more than a third of the
/// picture's width, the nearest 1, 2 or 5 times a power of ten for which it is not.
double scaleBarLength_m(const Camera& camera);

/// Draws the legend of node states in the bottom left corner.
void drawNodeLegend(Image& image);

/// The depth buffer of an OpenGL picture that has `scale` times as many pixels in each direction as the
/// camera's picture; `read` returns a part of it, rows from bottom to top, 0 (near) to 1 (far).
struct DepthPicture {
  std::function<std::vector<float>(const PixelRectangle& part)> read;
  int scale = 1;
};

/// Draws tool nodes as dots in the colours of their states, far ones first. Free nodes are drawn only where
/// they are visible, others always: filled where visible, as a ring where something hides them. Nodes without
/// a state are left out. Depths are read once, of a rectangle around the nodes.
void drawNodes(Image& image, const Camera& camera, const Scene& scene, const State& state,
               const DepthPicture& depths);

}  // namespace fissure
