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

/// What `fissure render` was asked for.
struct RenderJob {
  std::filesystem::path result;
  std::vector<std::string> runs;                ///< empty: all
  std::optional<std::filesystem::path> folder;  ///< for pictures
  std::optional<std::filesystem::path> video;   ///< its ending is one of videoKinds()
  bool separate = false;                        ///< pictures of one run each
  bool force = false;                           ///< replace what is there
  TimeSelection times;
  std::optional<std::pair<int, int>> size_px;  ///< of a panel; default: the scenario's frames, or theirs
  CameraChoice camera;
  int columns = 4;
  double frames_per_s = 25;
  double slow_motion = 1;
};

/// What came of a job.
struct RenderOutcome {
  std::size_t pictures = 0;        ///< written to the folder
  std::size_t frames = 0;          ///< of the video
  bool interrupted = false;        ///< pictures that were finished stay, of a video nothing does
  std::exception_ptr video_error;  ///< why there is no video though the pictures are written
};

/// Draws and writes, and shows on standard error how far it is. Throws InputError before anything is drawn,
/// but for a missing ffmpeg when there are pictures to be written: that is kept in the outcome. RunError for
/// what cannot be written; pictures that were finished stay, of a video nothing does.
RenderOutcome render(const RenderJob& job);

}  // namespace fissure
