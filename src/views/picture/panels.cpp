#include "picture/panels.h"

#include <algorithm>

#include "render/canvas.h"
#include "render/palette.h"

namespace fissure {

namespace {

constexpr int gap_px = 2;  ///< even: it keeps even sizes even, which videos want

void copyInto(Image& image, const Image& panel, int left_px, int top_px) {
  const std::ptrdiff_t row = 3 * static_cast<std::ptrdiff_t>(panel.width_px);
  for (int y = 0; y < panel.height_px; ++y)
    std::copy_n(panel.rgb.begin() + y * row, row,
                image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(top_px + y) * image.width_px + left_px));
}

}  // namespace

PictureSize joinedSize(const PictureSize& panel, int panels, int columns) {
  const long long across = std::min(panels, columns);
  const long long down = (panels + columns - 1) / columns;
  return {across * panel.width_px + (across - 1) * gap_px, down * panel.height_px + (down - 1) * gap_px};
}

Image joinPanels(const std::vector<Image>& panels, int columns) {
  const int width_px = panels.front().width_px, height_px = panels.front().height_px;
  const PictureSize size = joinedSize({width_px, height_px}, static_cast<int>(panels.size()), columns);
  Image image = emptyPicture(static_cast<int>(size.width_px), static_cast<int>(size.height_px));
  const auto gap = [&](int left_px, int top_px, int right_px, int bottom_px) {
    fillRectangle(image, Point2(left_px, top_px), Point2(right_px, bottom_px), palette::grid);
  };
  for (int x = width_px; x < image.width_px; x += width_px + gap_px) gap(x, 0, x + gap_px, image.height_px);
  for (int y = height_px; y < image.height_px; y += height_px + gap_px) gap(0, y, image.width_px, y + gap_px);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    copyInto(image, panels[i], column * (width_px + gap_px), row * (height_px + gap_px));
  }
  return image;
}

Image emptyPicture(int width_px, int height_px) {
  Image image{width_px, height_px, {}};
  image.rgb.resize(3 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    image.rgb[i] = palette::background.r;
    image.rgb[i + 1] = palette::background.g;
    image.rgb[i + 2] = palette::background.b;
  }
  return image;
}

Image faded(Image image) {
  const Colour to = palette::background;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const int background = i % 3 == 0 ? to.r : i % 3 == 1 ? to.g : to.b;
    image.rgb[i] = static_cast<std::uint8_t>((image.rgb[i] + 2 * background + 1) / 3);
  }
  return image;
}

}  // namespace fissure
