#pragma once

#include <vector>

#include "base/image.h"

namespace fissure {

/// Joins panels of equal size into one picture, row by row with `columns` panels in each and thin lines
/// between them. A single panel is returned as it is; unused cells are background.
Image joinPanels(const std::vector<Image>& panels, int columns);

/// The size of a picture.
struct PictureSize {
  long long width_px = 0;
  long long height_px = 0;
};
/// The size of the picture that joinPanels() makes of that many panels.
PictureSize joinedSize(const PictureSize& panel, int panels, int columns);

/// A picture of background colour.
Image emptyPicture(int width_px, int height_px);
/// The picture blended by two thirds into the background, for a run that has ended.
Image faded(Image image);

}  // namespace fissure
