#pragma once

#include <string>

#include "base/image.h"

namespace fissure {

/// The picture as a WebP file (lossy, `quality` 0 to 100), at most `width_px` wide; a wider one is made
/// smaller, its shape kept. The same bytes for the same picture. Throws RunError when libwebp cannot.
std::string encodeWebp(const Image& image, int width_px, double quality);

}  // namespace fissure
