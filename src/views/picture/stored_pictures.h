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

/// The settings of a camera that a user states; the others are those of the scenario's frames, or of the
/// default camera.
struct CameraChoice {
  std::optional<Vec3> position_m, look_at_m, up;
  std::optional<double> field_of_view_deg;
};

/// Settings of the pictures of a result.
struct PictureSettings {
  FrameSettings frames;  ///< the scenario's, or the defaults; width and height are those of a panel
  CameraChoice camera;
  int columns = 4;  ///< panels in a row
};

/// Pictures of stored snapshots with one panel per run, all with the same camera: the stated one, or one that
/// has the first states of all these runs in view. A panel is bitwise the frame that the run itself draws,
/// except where a run has ended early: its last panel then states how it ended, and later panels show that
/// state, faded. A run without snapshots has an empty panel with a note.
class StoredPictures {
 public:
  /// Opens the `runs` of a result, at least one; `ground_height_m` comes from the scenario, as it is not
  /// stored with them. Draws nothing yet. Throws InputError when the result is damaged, or the camera or a
  /// size is impossible.
  StoredPictures(const std::filesystem::path& file, const std::vector<PipelineResult>& runs,
                 const PictureSettings& settings, std::optional<double> ground_height_m);
  ~StoredPictures();
  StoredPictures(StoredPictures&&) noexcept;

  /// The times of the snapshots of all these runs, ascending, each once; empty: there are no pictures.
  const std::vector<double>& times_s() const { return times_s_; }
  PictureSize size() const { return size_; }
  /// Reads all that picture() reads for this time, and throws InputError when it is damaged.
  void check(double time_s) const;
  /// Draws the picture of one of times_s(). The first call loads the renderer. Throws InputError when the
  /// result is damaged, RunError when drawing fails.
  Image picture(double time_s);

 private:
  class Panel;

  PictureSettings settings_;
  std::vector<Panel> panels_;
  std::vector<double> times_s_;
  PictureSize size_;
};

}  // namespace fissure
