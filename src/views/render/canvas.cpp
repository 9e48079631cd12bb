#include "render/canvas.h"

#include <algorithm>
#include <cmath>

namespace fissure {
namespace {

void blendPixel(Image& image, int x, int y, Colour colour, double coverage) {
  const double opacity = coverage * colour.a / 255;
  std::uint8_t* pixel = &image.rgb[3 * (static_cast<std::size_t>(y) * image.width_px + x)];
  const std::uint8_t channels[3] = {colour.r, colour.g, colour.b};
  for (int i = 0; i < 3; ++i) {
    pixel[i] = static_cast<std::uint8_t>(std::lround(pixel[i] + opacity * (channels[i] - pixel[i])));
  }
}

/// The pixel that holds a coordinate, kept in the picture and free of overflow.
int clampedPixel(double coordinate_px, int size_px) {
  return static_cast<int>(std::floor(std::clamp(coordinate_px, 0.0, size_px - 1.0)));
}

}  // namespace

void drawStroke(Image& image, const Point2& from_px, const Point2& to_px, double width_px, Colour colour) {
  if (!from_px.allFinite() || !to_px.allFinite()) {
    return;
  }
  const double reach_px = width_px / 2 + 1;
  const Point2 low = from_px.cwiseMin(to_px).array() - reach_px;
  const Point2 high = from_px.cwiseMax(to_px).array() + reach_px;
  if (high.x() < 0 || high.y() < 0 || low.x() > image.width_px || low.y() > image.height_px) {
    return;
  }
  const Point2 along = to_px - from_px;
  const double length_squared = along.squaredNorm();
  for (int y = clampedPixel(low.y(), image.height_px); y <= clampedPixel(high.y(), image.height_px); ++y) {
    for (int x = clampedPixel(low.x(), image.width_px); x <= clampedPixel(high.x(), image.width_px); ++x) {
      const Point2 offset = Point2(x + 0.5, y + 0.5) - from_px;
      const double share =
          length_squared > 0 ? std::clamp(offset.dot(along) / length_squared, 0.0, 1.0) : 0.0;
      const double distance_px = (offset - share * along).norm();
      const double coverage = std::clamp(width_px / 2 - distance_px + 0.5, 0.0, 1.0);
      if (coverage > 0) {
        blendPixel(image, x, y, colour, coverage);
      }
    }
  }
}

void drawDisc(Image& image, const Point2& centre_px, double radius_px, Colour colour) {
  drawStroke(image, centre_px, centre_px, 2 * radius_px, colour);
}

void fillRectangle(Image& image, const Point2& top_left_px, const Point2& bottom_right_px, Colour colour) {
  const int left = std::max(0, static_cast<int>(std::floor(top_left_px.x())));
  const int top = std::max(0, static_cast<int>(std::floor(top_left_px.y())));
  const int right = std::min(image.width_px, static_cast<int>(std::ceil(bottom_right_px.x())));
  const int bottom = std::min(image.height_px, static_cast<int>(std::ceil(bottom_right_px.y())));
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      blendPixel(image, x, y, colour, 1);
    }
  }
}

namespace {

/// Sums rows first, which the compiler does for many bytes at once, and divides by a constant.
template <int scale>
void averageBlocks(std::span<const std::uint8_t> rgba, Image& image) {
  const auto width = static_cast<std::size_t>(image.width_px),
             height = static_cast<std::size_t>(image.height_px);
  const std::size_t row_bytes = width * scale * 4;
  std::vector<std::uint16_t> sums(row_bytes);
  std::uint8_t* out = image.rgb.data();
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* row = rgba.data() + row_bytes * (height - 1 - y) * scale;
    std::copy_n(row, row_bytes, sums.begin());
    for (int i = 1; i < scale; ++i)
      for (std::size_t k = 0; k < row_bytes; ++k)
        sums[k] = static_cast<std::uint16_t>(sums[k] + row[i * row_bytes + k]);
    for (const std::uint16_t* block = sums.data(); block != sums.data() + row_bytes; block += 4 * scale) {
      for (int channel = 0; channel < 3; ++channel) {
        unsigned sum = scale * scale / 2;
        for (int j = 0; j < scale; ++j) sum += block[4 * j + channel];
        *out++ = static_cast<std::uint8_t>(sum / (scale * scale));
      }
    }
  }
}

}  // namespace

Image downsample(std::span<const std::uint8_t> rgba, int width_px, int height_px, int scale) {
  Image image{width_px, height_px, {}};
  image.rgb.resize(static_cast<std::size_t>(width_px) * height_px * 3);
  if (scale == 1)
    averageBlocks<1>(rgba, image);
  else
    averageBlocks<2>(rgba, image);
  return image;
}

}  // namespace fissure
