#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "files/temporary_file.h"
#include "process/fed_process.h"

namespace fissure {

/// Names of the kinds of video, which are the endings of their files: "mp4", "webm", "gif".
const std::vector<std::string>& videoKinds();

struct VideoSettings {
  std::string kind = "mp4";  ///< of videoKinds()
  int width_px = 0;
  int height_px = 0;
  double frames_per_s = 25;
};

/// What ffmpeg is told: raw pictures from its standard input become `file`. The same pictures give the same
/// bytes with the same ffmpeg.
std::vector<std::string> ffmpegArguments(const VideoSettings& settings, const std::filesystem::path& file);

/// A video in the making. Under its name stands either the whole file or what stood there before.
class VideoFile {
 public:
  /// Starts `ffmpeg`; `stop_descriptor` as for FedProcess. Throws RunError.
  VideoFile(const std::filesystem::path& file, const std::filesystem::path& ffmpeg,
            const VideoSettings& settings, int stop_descriptor);

  /// All of the size that the settings say. Throws RunError with what ffmpeg said last.
  void add(const Image& image);
  /// The last call. Throws RunError, also when the file cannot take its name.
  void finish();

 private:
  std::filesystem::path file_;
  TemporaryFile temporary_;
  FedProcess ffmpeg_;
};

}  // namespace fissure
