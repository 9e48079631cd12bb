#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "base/image.h"
#include "render/palette.h"

namespace fissure {

using Point2 = Eigen::Vector2d;  ///< pixels from the left and the top; pixel i covers [i, i + 1)

/// Functions that draw on a finished picture with smooth edges and the opacity colour.a; parts outside of the
/// picture are cut off.

/// Draws a straight stroke with round ends, or a dot where both ends are equal.
void drawStroke(Image& image, const Point2& from_px, const Point2& to_px, double width_px, Colour colour);

void drawDisc(Image& image, const Point2& centre_px, double radius_px, Colour colour);

/// Fills whole pixels between two corners.
void fillRectangle(Image& image, const Point2& top_left_px, const Point2& bottom_right_px, Colour colour);

/// A part of an OpenGL picture, in pixels from its bottom left corner.
struct PixelRectangle {
  int left = 0;
  int bottom = 0;
  int columns = 0;
  int rows = 0;
};

/// Reduces an OpenGL picture of (width_px * scale) x (height_px * scale) pixels, with 4 bytes per pixel and
/// rows from BOTTOM to top: each pixel of the result is the rounded mean of `scale` x `scale` pixels. `scale`
/// is 1 or 2.
Image downsample(std::span<const std::uint8_t> rgba, int width_px, int height_px, int scale);

}  // namespace fissure
