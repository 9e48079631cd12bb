#pragma once

#include <string>
#include <vector>

#include "hdf5/h5.h"

namespace fissure::h5 {

/// Whether rows are appended along an axis of that name: "time", "snapshot_time", "frame_time".
bool isRowAxis(const std::string& axis);

/// The axes of a dataset of a finished file, by the dimension scales attached to it; a scale has itself as
/// axis. Throws RunError when one has no name.
std::vector<std::string> axisNames(hid_t dataset, const std::string& name);

/// Whether an attribute belongs to the dimension scales of its dataset, and means nothing in another file.
bool isScaleAttribute(const std::string& name);

}  // namespace fissure::h5
