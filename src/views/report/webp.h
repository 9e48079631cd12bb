#pragma once

#include <string>

#include "base/image.h"

namespace fissure {

/// Encodes a picture as a WebP file (lossy, `quality` 0 to 100), reduced to at most `width_px` columns with
/// its aspect ratio kept. The same picture gives the same bytes. Throws RunError when libwebp fails.
std::string encodeWebp(const Image& image, int width_px, double quality);

}  // namespace fissure
