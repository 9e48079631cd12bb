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
  std::vector<std::size_t> dropped_rows;   ///< rows without a pose
  std::vector<std::size_t> repeated_rows;  ///< rows with the time stamp of a row kept before them
};

/// Reads a log. The rules:
///   - a row of which a needed cell is empty, absent, infinite or not a number, or whose quaternion is zero,
///   has no pose
///     and is dropped (columns of unequal length end in such rows);
///   - time is the time column minus its value in the first row kept, or the row's index over rate_hz, where
///   a dropped
///     row still takes its time;
///   - a time stamp that was there before drops the later row; one before an earlier row's is an InputError,
///   because
///     then no rule says which of the two is the motion;
///   - quaternions are normalised. Frozen samples and jumps are kept as they are.
/// `where`: the path of the settings in their file, for messages. Throws InputError, see makeMotion.
DeviceLog readDeviceLog(const ReplayMotion& settings, const std::filesystem::path& file,
                        const std::string& where, const LogFiles& files);

}  // namespace fissure
