#pragma once

#include <string>
#include <vector>

#include "hdf5/h5.h"

namespace fissure::h5 {

/// Whether an axis of this name is one along which rows are appended: "time", "snapshot_time" or
/// "frame_time".
bool isRowAxis(const std::string& axis);

/// The names of the axes of a dataset in a finished file, from its dimension scales; the axis of a scale is
/// the scale itself. Throws RunError when an axis has no name.
std::vector<std::string> axisNames(hid_t dataset, const std::string& name);

/// Whether an attribute belongs to the mechanism of dimension scales, and so has no meaning in another file.
bool isScaleAttribute(const std::string& name);

}  // namespace fissure::h5
