#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "base/image.h"
#include "render/palette.h"

namespace fissure {

using Point2 = Eigen::Vector2d;  ///< pixels from the left and from the top; pixel i covers [i, i + 1)

/// Drawing on a finished picture, with smooth edges; everything outside it is cut off. The opacity is
/// colour.a.

/// A straight stroke with round ends; both ends equal: a dot.
void drawStroke(Image& image, const Point2& from_px, const Point2& to_px, double width_px, Colour colour);

void drawDisc(Image& image, const Point2& centre_px, double radius_px, Colour colour);

/// Covers whole pixels from corner to corner.
void fillRectangle(Image& image, const Point2& top_left_px, const Point2& bottom_right_px, Colour colour);

/// The picture that `rgba` shows: 4 bytes a pixel, rows from BOTTOM to top, each of its pixels the rounded
/// mean of `scale` x `scale` of those. rgba holds (width_px * scale) x (height_px * scale) pixels.
Image downsample(std::span<const std::uint8_t> rgba, int width_px, int height_px, int scale);

}  // namespace fissure
