#pragma once

#include <string_view>
#include <vector>

#include "render/canvas.h"

namespace fissure {

/// A stroke font of fixed width. One unit is a sixth of the height of a capital letter; a glyph is 4 units
/// wide and 8 units high, 2 below the base line and 6 above.
namespace font {

inline constexpr double advance_units = 5.5;
inline constexpr double line_units = 11;

/// The polylines of a printable ASCII character (0x20..0x7e) in units, x from its left edge, y upwards from 2
/// below the base line. A polyline of two equal points is a dot. Other characters are drawn as '?'.
std::vector<std::vector<Point2>> strokes(char character);

/// Size of a unit in pixels for a picture of this height, at least 1: text is about 1/50 as high as the
/// picture.
double unitFor(int height_px);

double textWidth_px(std::string_view text, double unit_px);

/// Draws one line of text; `base_px` is the left end of its base line.
void drawText(Image& image, const Point2& base_px, std::string_view text, double unit_px, Colour colour);

}  // namespace font
}  // namespace fissure
