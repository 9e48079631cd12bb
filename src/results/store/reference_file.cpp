#include "store/reference_file.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "hdf5/axes.h"
#include "hdf5/group_builder.h"
#include "hdf5/output_file.h"
#include "store/result_file.h"

namespace fissure {

namespace {

// Inputs of force laws: a few of the steps would be of no use, and what the laws make of them is in the
// series. Volumes are large, and what comes of them is in the series too.
const std::set<std::string> left_out_groups = {"timing", "frame_images", "vtk", "force_inputs", "volumes"};
const std::set<std::string> picture_axes = {"frame_time", "image_x", "image_y", "channel"};
constexpr hsize_t kContiguousBytes = 2048;  // smaller datasets gain nothing from compression

/// Rows 0, every, 2 every ... and the last: at most `most` of them.
struct PickedRows {
  hsize_t length = 0, every = 1, count = 0;
  bool last_beside = false;  ///< the last row is not among those

  PickedRows(hsize_t rows, std::size_t most) : length(rows) {
    if (rows == 0) return;
    while ((rows - 1) / every + 2 > std::max<hsize_t>(most, 2) && every < rows) ++every;
    count = (rows - 1) / every + 1;
    last_beside = (rows - 1) % every != 0;
  }
  hsize_t total() const { return count + (last_beside ? 1 : 0); }
};

/// Selects the picked rows of `axis`, and all of the others.
void select(const h5::Id& space, const std::vector<hsize_t>& shape, std::size_t axis, const PickedRows& rows,
            const std::string& name) {
  std::vector<hsize_t> start(shape.size(), 0), stride(shape.size(), 1), size = shape;
  stride[axis] = rows.every;
  size[axis] = rows.count;
  h5::check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), stride.data(), size.data(), nullptr),
            "cannot read", name);
  if (!rows.last_beside) return;
  start[axis] = rows.length - 1;
  stride[axis] = size[axis] = 1;
  h5::check(H5Sselect_hyperslab(space, H5S_SELECT_OR, start.data(), stride.data(), size.data(), nullptr),
            "cannot read", name);
}

h5::Id smallProperties(const std::vector<hsize_t>& shape, std::size_t value_bytes, const std::string& name) {
  h5::Id properties = h5::datasetProperties();
  hsize_t bytes = value_bytes;
  for (const hsize_t length : shape) bytes *= length;
  if (shape.empty() || bytes < kContiguousBytes) return properties;
  const int rank = static_cast<int>(shape.size());
  h5::check(H5Pset_chunk(properties, rank, shape.data()), "cannot create dataset", name);
  h5::check(H5Pset_shuffle(properties), "cannot create dataset", name);
  h5::check(H5Pset_deflate(properties, 6), "cannot create dataset", name);
  return properties;
}

/// Copies groups dataset by dataset. Dimension scales are attached anew, as their links cannot be copied.
class ReferenceCopy {
 public:
  ReferenceCopy(const ReferenceSize& size, const h5::OutputFile& file) : size_(size), file_(file) {}

  void copyGroup(hid_t from, hid_t to) const {
    for (const std::string& name : h5::attributeNames(from)) h5::copyAttribute(from, to, name);
    for (const std::string& name : h5::childNames(from)) {
      if (left_out_groups.contains(name)) continue;
      const h5::Id child = h5::openObject(from, name);
      if (h5::isGroup(child)) {
        copyGroup(child, h5::createGroup(to, name));
      } else if (!h5::isView(child)) {
        copyDataset(child, to, name);
      }
      file_.checkWritten();
    }
  }

 private:
  void copyDataset(hid_t from, hid_t to, const std::string& name) const;

  const ReferenceSize& size_;
  const h5::OutputFile& file_;
};

void ReferenceCopy::copyDataset(hid_t from, hid_t to, const std::string& name) const {
  const std::vector<std::string> axes = h5::axisNames(from, name);
  if (std::any_of(axes.begin(), axes.end(), [](const auto& axis) { return picture_axes.contains(axis); }))
    return;
  h5::requireStored(from);
  std::vector<hsize_t> shape = h5::shapeOf(from);
  const h5::Id type(H5Dget_type(from), H5Tclose, "cannot read", name);
  const h5::Id source(H5Dget_space(from), H5Sclose, "cannot read", name);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!h5::isRowAxis(axes[i]) || shape[i] == 0) continue;
    const PickedRows rows(shape[i], axes[i] == "time" ? size_.steps : size_.snapshots);
    select(source, shape, i, rows, name);
    shape[i] = rows.total();
  }
  const h5::Id space(shape.empty() ? H5Screate(H5S_SCALAR)
                                   : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose, "cannot create dataset", name);
  const h5::Id made(H5Dcreate2(to, name.c_str(), type, space, H5P_DEFAULT,
                               smallProperties(shape, H5Tget_size(type), name), H5P_DEFAULT),
                    H5Dclose, "cannot create dataset", name);
  h5::copyValues(from, source, made, name);
  std::string dimensions;
  for (const std::string& axis : axes) dimensions += (dimensions.empty() ? "" : " ") + axis;
  for (const std::string& attribute : h5::attributeNames(from))
    if (!h5::isScaleAttribute(attribute)) h5::copyAttribute(from, made, attribute);
  if (!axes.empty()) h5::setAttribute(made, dimensions_attribute, dimensions);
}

void copyResult(const h5::Id& from, const h5::OutputFile& to, const ReferenceSize& size) {
  const ReferenceCopy copy(size, to);
  copy.copyGroup(from, to);
  const h5::Id pipelines = h5::openGroup(to, "pipelines");
  attachScales(pipelines);
  h5::setAttribute(to, "reference", std::int32_t{1});
  h5::setAttribute(to, "complete", std::int32_t{1});
}

}  // namespace

bool inReference(const StoredQuantity& quantity) {
  if (picture_axes.contains(quantity.row_axis)) return false;
  if (left_out_groups.contains(quantity.name.substr(0, quantity.name.find('/')))) return false;
  return std::none_of(quantity.axes.begin(), quantity.axes.end(),
                      [](const StoredAxis& axis) { return picture_axes.contains(axis.name); });
}

void writeReference(const std::filesystem::path& target, const std::filesystem::path& result,
                    const ReferenceSize& size) {
  readResultInfo(result);  // says what is wrong with it
  try {
    const h5::Id from = h5::openToRead(result);
    ReplacementFile replacement(target);
    copyResult(from, replacement.file(), size);
    replacement.close();
    replacement.commit();
  } catch (const RunError& error) {
    throw RunError(target.string() + ": " + error.what());
  }
}

}  // namespace fissure
