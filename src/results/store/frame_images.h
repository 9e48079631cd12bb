#pragma once

#include <string>

#include "hdf5/h5.h"

namespace fissure {

/// Frames that get a view: opening a file takes netCDF readers time with the square of these (1000: 1 s,
/// 6000: 400 s).
inline constexpr hsize_t most_frame_images = 1000;

/// Gives each picture of the dataset `frames` in `group`, up to most_frame_images, a dataset of its own in
/// the subgroup frame_images (000000, 000001, ...): virtual, so that no byte is stored twice, and with scales
/// and the attributes of the HDF5 Image specification, which image viewers look for. `group_path` is the
/// group's absolute name. Call it once `frames` has its final length. Throws RunError.
void addFrameImages(hid_t group, const std::string& group_path);

}  // namespace fissure
