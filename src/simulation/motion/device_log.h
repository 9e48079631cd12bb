#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/motions.h"
#include "text/log_text.h"

namespace fissure {

/// The samples of a device log in the device's frame, in order of time: one entry for each row that has a
/// pose.
struct DeviceLog {
  std::vector<double> times_s;  ///< log time, strictly increasing
  std::vector<Vec3> positions_m;
  std::vector<Quat> orientations;         ///< unit; empty when the settings name no quaternion columns
  std::vector<std::size_t> rows;          ///< row of each sample in the file, from 0 below the header
  std::vector<int> lines;                 ///< line number of each sample in the file, from 1
  std::vector<std::size_t> dropped_rows;  ///< rows without a pose
  /// Those of the dropped rows with a number too large for a measurement.
  std::vector<std::size_t> beyond_reason;
  std::string first_beyond_reason;  ///< text about the first of these: its place and its number; empty: none
  std::vector<std::size_t> repeated_rows;  ///< rows left out because an earlier row has the same time stamp
  std::vector<std::size_t> filtered_rows;  ///< rows left out by the settings' `where`
};

/// The largest coordinate, in its unit, that counts as a measurement: some trackers write -3.7e28 where they
/// see nothing.
inline constexpr double kReasonable = 1e6;

/// The largest time stamp (in its unit), frame number and part of a quaternion that count as measurements:
/// nanoseconds since 1970 are 1.8e18, and quaternions in fixed point have parts of 2^30 or 2^62.
inline constexpr double kReasonableStamp = 1e19;

/// Reads a log by these rules:
///   - a row that `settings.where` leaves out is ignored;
///   - a row has no pose and is dropped where a needed cell is empty, absent, infinite, not a number or
///     beyond the limits above, or where its quaternion is zero (columns of unequal length end in such rows);
///   - time is the time column in its unit, or the frame column over rate_hz, minus its value in the first
///     row kept; without both it is the row's index over rate_hz, in which dropped and ignored rows are
///     counted;
///   - of rows with equal time stamps the first is kept; a time stamp that is smaller than that of an earlier
///     row is an InputError, because it is unknown which of the two is the motion;
///   - quaternions of any length but zero are normalised, also those in fixed point. Frozen samples and jumps
///     are kept.
/// `where`: the key path of the settings, for messages. Throws InputError as makeMotion does.
DeviceLog readDeviceLog(const ReplayMotion& settings, const std::filesystem::path& file,
                        const std::string& where, const LogFiles& files);

}  // namespace fissure
