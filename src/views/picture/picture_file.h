#pragma once

#include <filesystem>

#include "base/image.h"

namespace fissure {

/// Writes a picture as a PNG file, 8 bits a channel; the same picture gives the same bytes. Under its name
/// stands either the whole file or what stood there before. Throws RunError.
void writePng(const std::filesystem::path& file, const Image& image);

}  // namespace fissure
