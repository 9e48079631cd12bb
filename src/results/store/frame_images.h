#pragma once

#include <string>

#include "hdf5/h5.h"

namespace fissure {

/// The largest number of frames with a view of their own. The time that netCDF readers need to open a file
/// grows with the square of this number (1 s for 1000, 400 s for 6000).
inline constexpr hsize_t most_frame_images = 1000;

/// Adds a virtual dataset for each picture of the dataset `frames` in `group`, up to most_frame_images, in
/// the subgroup frame_images (000000, 000001, ...). They have dimension scales and the attributes of the HDF5
/// Image specification, by which viewers recognise images. `group_path` is the absolute name of the group. To
/// be called when `frames` has its final length. Throws RunError.
void addFrameImages(hid_t group, const std::string& group_path);

}  // namespace fissure
