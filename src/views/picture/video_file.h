#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "files/temporary_file.h"
#include "process/fed_process.h"

namespace fissure {

/// The kinds of video, which are also the endings of their files: "mp4", "webm", "gif".
const std::vector<std::string>& videoKinds();

struct VideoSettings {
  /// One of videoKinds().
  std::string kind = "mp4";
  int width_px = 0;
  int height_px = 0;
  double frames_per_s = 25;
};

/// The command line with which ffmpeg turns raw pictures on its standard input into `file`. The same pictures
/// and the same ffmpeg give the same bytes.
std::vector<std::string> ffmpegArguments(const VideoSettings& settings, const std::filesystem::path& file);

/// An unfinished video. Its file is replaced completely by finish() or not at all.
class VideoFile {
 public:
  /// Starts the program `ffmpeg`; `stop_descriptor` as for FedProcess. Throws RunError when it cannot start.
  VideoFile(const std::filesystem::path& file, const std::filesystem::path& ffmpeg,
            const VideoSettings& settings, int stop_descriptor);

  /// Appends a frame, which must have the size of the settings. Throws RunError with ffmpeg's last message
  /// when it fails.
  void add(const Image& image);
  /// Completes the video; to be called last. Throws RunError when ffmpeg fails or the file cannot be renamed.
  void finish();

 private:
  std::filesystem::path file_;
  TemporaryFile temporary_;
  FedProcess ffmpeg_;
};

}  // namespace fissure
