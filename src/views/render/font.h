#pragma once

#include <string_view>
#include <vector>

#include "render/canvas.h"

namespace fissure {

/// An own stroke font of fixed width. One unit is a sixth of a capital's height; a glyph is 4 units wide and
/// spans 8 units: 2 below the base line and 6 above.
namespace font {

inline constexpr double advance_units = 5.5;
inline constexpr double line_units = 11;

/// The polylines of a printable ASCII character (0x20..0x7e) in units: x from its left edge, y up from 2
/// below the base line. A polyline whose two points are equal is a dot. Other characters: those of '?'.
std::vector<std::vector<Point2>> strokes(char character);

/// Pixels a unit for a picture of this height: text stays near 1/50 of it, never below 1.
double unitFor(int height_px);

double textWidth_px(std::string_view text, double unit_px);

/// Writes one line; `base_px` is the left end of its base line.
void drawText(Image& image, const Point2& base_px, std::string_view text, double unit_px, Colour colour);

}  // namespace font
}  // namespace fissure
