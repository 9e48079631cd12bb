#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "picture/panels.h"
#include "scenario/scenario.h"
#include "store/result_file.h"
#include "store/snapshot_reader.h"

namespace fissure {

/// What is stated of a camera; the rest is as the scenario's frames have it, or as the default camera has.
struct CameraChoice {
  std::optional<Vec3> position_m, look_at_m, up;
  std::optional<double> field_of_view_deg;
};

/// How the pictures of a result shall look.
struct PictureSettings {
  FrameSettings frames;  ///< the scenario's, or the defaults; its size is that of a panel
  CameraChoice camera;
  int columns = 4;  ///< panels in a row
};

/// Pictures of stored snapshots, a panel for each run, all through one camera: the one that is stated, or the
/// one that has the first state of all these runs in view. A panel is the frame that the run itself draws, to
/// the last bit. Only where a run has ended short of what was asked of it, its last panel says how; later
/// ones show that state, faded. A run without snapshots has an empty panel that says so.
class StoredPictures {
 public:
  /// `runs` of the result, at least one; `ground_height_m` is not stored with them. Throws InputError when
  /// what is stored is damaged, or the camera or a size cannot be; draws nothing yet.
  StoredPictures(const std::filesystem::path& file, const std::vector<PipelineResult>& runs,
                 const PictureSettings& settings, std::optional<double> ground_height_m);
  ~StoredPictures();
  StoredPictures(StoredPictures&&) noexcept;

  /// Of the snapshots of all these runs, ascending, each once. Only when there is one, there are pictures.
  const std::vector<double>& times_s() const { return times_s_; }
  PictureSize size() const { return size_; }
  /// Reads what picture() will read.
  void check(double time_s) const;
  /// Loads the renderer at its first call. Throws InputError as above, RunError when drawing fails.
  Image picture(double time_s);

 private:
  class Panel;

  PictureSettings settings_;
  std::vector<Panel> panels_;
  std::vector<double> times_s_;
  PictureSize size_;
};

}  // namespace fissure
