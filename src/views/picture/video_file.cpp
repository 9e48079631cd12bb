#include "picture/video_file.h"

#include <fmt/core.h>

#include "base/error.h"
#include "text/scalars.h"

namespace fissure {

namespace {

using Words = std::vector<std::string>;

/// Half the colours (4:2:0) are what all players take, and that wants even sizes.
const std::string even_yuv =
    "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,"
    "scale=in_range=pc:out_range=tv:out_color_matrix=bt709:flags=accurate_rnd+full_chroma_int+bitexact,"
    "format=yuv420p";

const Words colour_tags = {"-colorspace", "bt709", "-color_primaries", "bt709",
                           "-color_trc",  "bt709", "-color_range",     "tv"};

Words encoderOf(const std::string& kind) {
  Words words;
  if (kind == "gif")  // colours of each picture's own: one table for all would need all in memory first
    return {"-filter_complex",
            "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-loop",
            "0"};
  if (kind == "webm")
    words = {"-vf", even_yuv,    "-c:v", "libvpx-vp9", "-crf", "24",      "-b:v",
             "0",   "-deadline", "good", "-cpu-used",  "4",    "-row-mt", "0"};
  else
    words = {"-vf", even_yuv,  "-c:v",   "libx264",   "-crf",
             "18",  "-preset", "medium", "-movflags", "+faststart"};
  words.insert(words.end(), colour_tags.begin(), colour_tags.end());
  return words;
}

}  // namespace

const std::vector<std::string>& videoKinds() {
  static const std::vector<std::string> kinds = {"mp4", "webm", "gif"};
  return kinds;
}

std::vector<std::string> ffmpegArguments(const VideoSettings& settings, const std::filesystem::path& file) {
  const std::string size = fmt::format("{}x{}", settings.width_px, settings.height_px);
  Words words = {"-hide_banner", "-loglevel", "error", "-nostdin", "-xerror"};
  const Words input = {"-f",          "rawvideo", "-pixel_format", "rgb24",
                       "-video_size", size,       "-framerate",    formatReal(settings.frames_per_s),
                       "-i",          "pipe:0"};
  const Words encoder = encoderOf(settings.kind);
  // One thread and no dates or versions: the same bytes every time. "file:" keeps names with a colon names.
  const Words output = {"-threads",
                        "1",
                        "-map_metadata",
                        "-1",
                        "-fflags",
                        "+bitexact",
                        "-flags:v",
                        "+bitexact",
                        "-f",
                        settings.kind,
                        "file:" + file.string()};
  for (const Words& more : {input, encoder, output}) words.insert(words.end(), more.begin(), more.end());
  return words;
}

VideoFile::VideoFile(const std::filesystem::path& file, const std::filesystem::path& ffmpeg,
                     const VideoSettings& settings, int stop_descriptor)
    : file_(file),
      temporary_(file),
      ffmpeg_(ffmpeg, ffmpegArguments(settings, temporary_.path()), stop_descriptor) {}

void VideoFile::add(const Image& image) try { ffmpeg_.write(image.rgb); } catch (const RunError& error) {
  throw RunError(file_.string() + ": " + error.what());
}

void VideoFile::finish() try {
  ffmpeg_.finish();
  temporary_.commit();
} catch (const RunError& error) {
  throw RunError(file_.string() + ": " + error.what());
}

}  // namespace fissure
