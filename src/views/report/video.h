#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace fissure {

/// The largest video in a page, bytes; pages with larger ones are slow to open.
inline constexpr std::size_t most_video_bytes = 16000000;

/// An MP4 or WebM file as a data URI, so that the page stays one file. Throws InputError when it is missing,
/// neither of them, or larger than most_video_bytes.
std::string videoUri(const std::filesystem::path& file);

}  // namespace fissure
