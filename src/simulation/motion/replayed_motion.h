#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/device_log.h"
#include "motion/device_opening.h"
#include "motion/device_to_scene.h"
#include "motion/motion.h"

namespace fissure {

/// A device log that is played back in the scene. Its rules in addition to those of readDeviceLog, each with
/// a count in summary():
///   - scenario time 0 is log time start_s; the replay ends at end_s or with the last sample;
///   - at the time of a sample the pose is the mapped sample; between samples it is interpolated;
///   - in a gap, between two samples more than max_gap_s apart, the pose stays that of the earlier sample and
///     jumps to the later one at its time, because the motion of the hand meanwhile is unknown (replay_gaps).
///     Before the first and after the last sample the pose is constant too;
///   - displacements between two samples of more than jump_m (replay_jumps) or faster than jump_speed_m_s
///     (replay_fast_steps), both before scaling, are played unchanged and counted, as are samples equal to
///     the one before, which a frozen device repeats (replay_held_samples);
///   - for a clamp one device axis is the opening, not a position; beyond its limits the opening stays
///     constant, and such samples are counted (replay_saturated_openings).
/// Only samples (replay_samples), displacements and rows between start_s and end_s are counted. notes() names
/// the first jump, the first fast step and the first number beyond the limits of a measurement.
class ReplayedMotion final : public Motion {
 public:
  /// `where`: the key path of the settings, for messages. Throws InputError as makeMotion does.
  ReplayedMotion(const ReplayMotion& settings, const std::filesystem::path& directory,
                 const std::string& where, const LogFiles& files);

  Pose poseAt(double time_s) const override;
  double openingAt(double time_s) const override;
  double duration_s() const override { return duration_s_; }
  /// Has replay_samples, replay_held_samples, replay_gaps, replay_jumps, replay_fast_steps,
  /// replay_dropped_rows (of which replay_rows_beyond_reason) and replay_repeated_rows; with a filter
  /// replay_filtered_rows; for a clamp replay_saturated_openings.
  Summary summary() const override { return summary_; }
  std::vector<std::string> notes() const override { return notes_; }

 private:
  /// Pose of the hand in the scene frame, including the axis that opens a clamp.
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
  /// Scene frame, with neighbours in one hemisphere; a single one where the log has no quaternions.
  std::vector<Quat> orientations_;
  std::optional<OpeningAxis> opening_;
  double max_gap_s_;
  double duration_s_ = 0;
  Summary summary_;
  std::vector<std::string> notes_;
};

}  // namespace fissure
