#pragma once

#include <filesystem>

#include "base/image.h"

namespace fissure {

/// Writes a picture as a PNG file with 8 bits per channel; the same picture gives the same bytes. The file is
/// replaced completely or not at all. Throws RunError when writing fails.
void writePng(const std::filesystem::path& file, const Image& image);

}  // namespace fissure
