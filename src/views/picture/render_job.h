#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture/picture_times.h"
#include "picture/stored_pictures.h"

namespace fissure {

/// The arguments of `fissure render`.
struct RenderJob {
  std::filesystem::path result;
  std::vector<std::string> runs;                ///< names of runs; empty: all
  std::optional<std::filesystem::path> folder;  ///< folder for pictures; no value: no pictures
  /// Video file, with an ending of videoKinds(); no value: no video.
  std::optional<std::filesystem::path> video;
  bool separate = false;  ///< separate pictures for each run instead of panels
  bool force = false;     ///< replace existing files
  TimeSelection times;
  /// Width and height of a panel; default: that of the scenario's frames.
  std::optional<std::pair<int, int>> size_px;
  CameraChoice camera;
  int columns = 4;
  double frames_per_s = 25;
  double slow_motion = 1;
};

/// The outcome of a job.
struct RenderOutcome {
  std::size_t pictures = 0;  ///< number of pictures written to the folder
  std::size_t frames = 0;    ///< number of frames in the video
  bool interrupted = false;  ///< stopped on request: finished pictures stay, an unfinished video is removed
  std::exception_ptr video_error;  ///< why there is no video, although the pictures are written
};

/// Draws and writes the pictures and the video, with a progress line on standard error. Throws InputError
/// before anything is drawn; only a missing ffmpeg, when there are pictures to be written too, is kept in the
/// outcome instead. Throws RunError when writing fails; finished pictures stay, an unfinished video is
/// removed.
RenderOutcome render(const RenderJob& job);

}  // namespace fissure
