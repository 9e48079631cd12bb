#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/motions.h"
#include "text/log_text.h"

namespace fissure {

/// The rows of a device log that have a pose, in the device's frame. One entry a row kept, in order of time.
struct DeviceLog {
  std::vector<double> times_s;  ///< log time, strictly increasing
  std::vector<Vec3> positions_m;
  std::vector<Quat> orientations;          ///< unit; empty when the settings name no quaternion columns
  std::vector<std::size_t> rows;           ///< each sample's row in the file, from 0 below the header
  std::vector<int> lines;                  ///< and its line, from 1
  std::vector<std::size_t> dropped_rows;   ///< rows without a pose
  std::vector<std::size_t> beyond_reason;  ///< of these, the rows with a number that is no measurement
  std::string first_beyond_reason;  ///< where the first of them is, and what number it has; empty: none
  std::vector<std::size_t> repeated_rows;  ///< rows with the time stamp of a row kept before them
  std::vector<std::size_t> filtered_rows;  ///< rows that the settings' `where` leaves out
};

/// A coordinate beyond this many of its unit is no measurement: some trackers write -3.7e28 where they see
/// nothing.
inline constexpr double kReasonable = 1e6;

/// Nor is a time stamp beyond this many of its unit, or such a frame, or such a part of a quaternion:
/// nanoseconds since 1970 are 1.8e18, and quaternions in fixed point have parts of 2^30 or 2^62.
inline constexpr double kReasonableStamp = 1e19;

/// Reads a log. The rules:
///   - a row that `where` leaves out is not looked at;
///   - a row of which a needed cell is empty, absent, infinite, not a number or beyond reason, or whose
///   quaternion is zero, has no pose and is dropped (columns of unequal length end in such rows);
///   - time is the time column in its unit, or the frame column over rate_hz, minus its value in the first
///   row kept; or else the row's index over rate_hz. A row that is dropped or left out still takes its time;
///   - a time stamp that was there before drops the later row; one before an earlier row's is an InputError,
///   because then no rule says which of the two is the motion;
///   - quaternions of any length but zero are normalised, fixed-point ones too. Frozen samples and jumps are
///   kept as they are.
/// `where`: the path of the settings in their file, for messages. Throws InputError, see makeMotion.
DeviceLog readDeviceLog(const ReplayMotion& settings, const std::filesystem::path& file,
                        const std::string& where, const LogFiles& files);

}  // namespace fissure
