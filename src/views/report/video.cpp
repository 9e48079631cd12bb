#include "report/video.h"

#include <fmt/core.h>

#include <string_view>

#include "base/error.h"
#include "files/input_file.h"
#include "report/base64.h"

namespace fissure {

namespace {

/// By the first bytes: ISO 14496-12 (a box `ftyp`), Matroska (the EBML header).
std::string typeOf(std::string_view bytes) {
  if (bytes.size() > 8 && bytes.substr(4, 4) == "ftyp") return "video/mp4";
  if (bytes.starts_with("\x1a\x45\xdf\xa3")) return "video/webm";
  return "";
}

}  // namespace

std::string videoUri(const std::filesystem::path& file) {
  const std::string name = file.string();
  requireInputFile(file, "a video");
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (size > most_video_bytes)
    throw InputError(inFile(name),
                     fmt::format("{} MB, expected a video of at most {} MB: it becomes part of the page",
                                 size / 1000000, most_video_bytes / 1000000));
  const std::string bytes = readInputFile(file, "a video");
  const std::string type = typeOf(bytes);
  if (type.empty()) throw InputError(inFile(name), "no video that browsers play, expected MP4 or WebM");
  return "data:" + type + ";base64," + base64(bytes);
}

}  // namespace fissure
