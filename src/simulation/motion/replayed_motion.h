#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/device_log.h"
#include "motion/device_opening.h"
#include "motion/device_to_scene.h"
#include "motion/motion.h"

namespace fissure {

/// A device log played back in the scene. The rules beyond those of readDeviceLog, each counted in summary():
///   - scenario time 0 is log time start_s; the replay ends at end_s or with the last sample;
///   - at the time of a sample the pose is that sample, mapped; between two it is interpolated;
///   - a gap, two samples more than max_gap_s apart, is held: the pose stays at the earlier sample and jumps
///   to the
///     later one at its time, because nobody knows what the hand did meanwhile (replay_gaps). The same before
///     a first sample and after a last one;
///   - a step of the device between two samples of more than jump_m (replay_jumps) or faster than
///   jump_speed_m_s (replay_fast_steps), both before scaling, is played as it is and counted, and so is a
///   sample equal to the one before it, as a frozen device repeats them (replay_held_samples);
///   - of a clamp one device axis is the opening and not position; beyond its limits the opening stays there,
///     and the samples are counted (replay_saturated_openings).
/// Counts are of what is replayed: samples (replay_samples), steps and rows between start_s and end_s.
/// notes() says which jump, fast step and number beyond reason comes first.
class ReplayedMotion final : public Motion {
 public:
  /// `where`: the path of the settings in their file, for messages. Throws InputError, see makeMotion.
  ReplayedMotion(const ReplayMotion& settings, const std::filesystem::path& directory,
                 const std::string& where, const LogFiles& files);

  Pose poseAt(double time_s) const override;
  double openingAt(double time_s) const override;
  double duration_s() const override { return duration_s_; }
  /// replay_samples, replay_held_samples, replay_gaps, replay_jumps, replay_fast_steps, replay_dropped_rows,
  /// of these replay_rows_beyond_reason, and replay_repeated_rows; with a filter replay_filtered_rows; of a
  /// clamp replay_saturated_openings.
  Summary summary() const override { return summary_; }
  std::vector<std::string> notes() const override { return notes_; }

 private:
  /// Of the hand, as the mapping has it in the scene: with the axis that opens a clamp.
  Pose handAt(double time_s) const;
  void setWindow(const ReplayMotion& settings, const std::string& file, const std::string& where);
  void count(const DeviceLog& log, const ReplayMotion& settings);
  void noteSteps(const DeviceLog& log, const ReplayMotion& settings, const std::string& file);
  bool isPlayed(double time_s) const;
  bool isStepPlayed(std::size_t to) const;
  void map(const DeviceLog& log, const DeviceToScene& mapping);
  void computeSlopes();
  bool isGap(std::size_t before) const;

  std::vector<double> times_s_;    ///< scenario time; negative before start_s
  std::vector<Vec3> positions_m_;  ///< scene frame
  std::vector<Vec3> slopes_m_s_;   ///< empty for linear interpolation
  std::vector<Quat>
      orientations_;  ///< scene frame, neighbours of one sign; one for all samples without quaternions
  std::optional<OpeningAxis> opening_;
  double max_gap_s_;
  double duration_s_ = 0;
  Summary summary_;
  std::vector<std::string> notes_;
};

}  // namespace fissure
