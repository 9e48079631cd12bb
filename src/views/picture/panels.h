#pragma once

#include <vector>

#include "base/image.h"

namespace fissure {

/// A picture of panels of one size, row by row with `columns` in each, thin lines between them; one panel is
/// the picture. Cells that stay free are empty.
Image joinPanels(const std::vector<Image>& panels, int columns);

/// The size of that picture: width and height.
struct PictureSize {
  long long width_px = 0;
  long long height_px = 0;
};
PictureSize joinedSize(const PictureSize& panel, int panels, int columns);

/// Nothing but background.
Image emptyPicture(int width_px, int height_px);
/// Two thirds on the way to the background: what is no longer going on.
Image faded(Image image);

}  // namespace fissure
