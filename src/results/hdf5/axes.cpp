#include "hdf5/axes.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <array>

#include "base/error.h"

namespace fissure::h5 {

namespace {

constexpr std::array<const char*, 3> row_axes = {"time", "snapshot_time", "frame_time"};
constexpr std::array<const char*, 5> scale_attributes = {"CLASS", "NAME", "REFERENCE_LIST", "DIMENSION_LIST",
                                                         "DIMENSION_LABELS"};

herr_t takeFirstScale(hid_t, unsigned, hid_t scale, void* name) {
  std::array<char, 256> text = {};
  H5DSget_scale_name(scale, text.data(), text.size());
  *static_cast<std::string*>(name) = text.data();
  return 1;
}

}  // namespace

bool isRowAxis(const std::string& axis) {
  return std::find(row_axes.begin(), row_axes.end(), axis) != row_axes.end();
}

std::vector<std::string> axisNames(hid_t dataset, const std::string& name) {
  if (check(H5DSis_scale(dataset), "cannot read the axes of", name) > 0)
    return {name.substr(name.rfind('/') + 1)};
  std::vector<std::string> axes(shapeOf(dataset).size());
  for (unsigned i = 0; i < axes.size(); ++i) {
    check(H5DSiterate_scales(dataset, i, nullptr, takeFirstScale, &axes[i]), "cannot read the axes of", name);
    if (axes[i].empty()) throw RunError(name + ": an axis has no name");
  }
  return axes;
}

bool isScaleAttribute(const std::string& name) {
  return std::find(scale_attributes.begin(), scale_attributes.end(), name) != scale_attributes.end();
}

}  // namespace fissure::h5
