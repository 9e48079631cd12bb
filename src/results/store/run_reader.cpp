#include "store/run_reader.h"

#include <algorithm>

#include "base/error.h"
#include "hdf5/axes.h"

namespace fissure {

namespace {

/// The names along an axis, which lie beside the dataset.
std::vector<std::string> labelsOf(hid_t group, const std::string& axis) {
  if (!h5::exists(group, axis)) return {};
  const h5::Id scale = h5::openDataset(group, axis);
  return h5::isText(scale) ? h5::readTexts(scale) : std::vector<std::string>{};
}

StoredQuantity describe(hid_t group, const h5::Id& dataset, const std::string& path) {
  StoredQuantity quantity;
  quantity.name = path;
  quantity.units = h5::textAttribute(dataset, "units");
  quantity.type = h5::typeName(dataset);
  const std::vector<hsize_t> shape = h5::shapeOf(dataset);
  const std::vector<std::string> axes = h5::axisNames(dataset, path);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (h5::isRowAxis(axes[i])) {
      quantity.row_axis = axes[i];
      quantity.rows = shape[i];
    } else {
      quantity.axes.push_back({axes[i], shape[i], labelsOf(group, axes[i])});
    }
  }
  return quantity;
}

void listQuantities(hid_t group, const std::string& prefix, std::vector<StoredQuantity>& quantities) {
  for (const std::string& name : h5::childNames(group)) {
    if (prefix.empty() && name == "timing") continue;
    const h5::Id child = h5::openObject(group, name);
    if (h5::isGroup(child)) {
      listQuantities(child, prefix + name + "/", quantities);
    } else if (!h5::isView(child) && !h5::isText(child)) {
      quantities.push_back(describe(group, child, prefix + name));
    }
  }
}

/// Where the rows run along an axis that is not the first, `values` has them apart: brings them together.
std::vector<double> rowByRow(std::vector<double> values, const std::vector<hsize_t>& shape,
                             std::size_t row_axis) {
  std::size_t before = 1, after = 1;
  for (std::size_t i = 0; i < row_axis; ++i) before *= shape[i];
  for (std::size_t i = row_axis + 1; i < shape.size(); ++i) after *= shape[i];
  if (before == 1) return values;
  const std::size_t rows = shape[row_axis];
  std::vector<double> ordered(values.size());
  for (std::size_t b = 0; b < before; ++b)
    for (std::size_t row = 0; row < rows; ++row)
      std::copy_n(&values[(b * rows + row) * after], after, &ordered[(row * before + b) * after]);
  return ordered;
}

/// Fills `values` with what lies at `start`, `size` along each axis.
void readBlock(const h5::Id& dataset, const std::string& name, const std::vector<hsize_t>& start,
               const std::vector<hsize_t>& size, hid_t type, void* values) {
  const h5::Id from(H5Dget_space(dataset), H5Sclose, "cannot read", name);
  if (!size.empty())
    h5::check(H5Sselect_hyperslab(from, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
              "cannot read", name);
  const h5::Id to(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose,
                  "cannot read", name);
  h5::check(H5Dread(dataset, type, to, from, H5P_DEFAULT, values), "cannot read", name);
}

}  // namespace

struct RunReader::Opened {
  h5::Id file;
  h5::Id group;
};

std::size_t StoredQuantity::columns() const {
  std::size_t count = 1;
  for (const StoredAxis& axis : axes) count *= axis.length;
  return count;
}

RunReader::RunReader(const std::filesystem::path& file, const std::string& pipeline)
    : path_(file), opened_(std::make_unique<Opened>()) {
  try {
    opened_->file = h5::openToRead(file);
    opened_->group = h5::openGroup(opened_->file, "/pipelines/" + pipeline);
    listQuantities(opened_->group, "", quantities_);
  } catch (const RunError& error) {
    throw InputError(inFile(file), error.what());
  }
}

RunReader::RunReader(RunReader&&) noexcept = default;
RunReader::~RunReader() = default;

const StoredQuantity* RunReader::find(const std::string& name) const {
  for (const StoredQuantity& quantity : quantities_)
    if (quantity.name == name) return &quantity;
  return nullptr;
}

std::vector<double> RunReader::rows(const StoredQuantity& quantity, std::size_t first,
                                    std::size_t count) const try {
  const h5::Id dataset = h5::openDataset(opened_->group, quantity.name);
  std::vector<hsize_t> size = h5::shapeOf(dataset);
  std::vector<hsize_t> start(size.size(), 0);
  const std::vector<std::string> axes = h5::axisNames(dataset, quantity.name);
  const auto row_axis =
      static_cast<std::size_t>(std::find(axes.begin(), axes.end(), quantity.row_axis) - axes.begin());
  if (row_axis < size.size()) {
    start[row_axis] = first;
    size[row_axis] = count;
  }
  if (count > 1) h5::requireStored(dataset);  // of single rows there may be many
  std::vector<double> values(count * quantity.columns());
  if (values.empty()) return values;
  readBlock(dataset, quantity.name, start, size, H5T_NATIVE_DOUBLE, values.data());
  return row_axis < size.size() ? rowByRow(std::move(values), size, row_axis) : values;
} catch (const RunError& error) {
  throw InputError(inFile(path_), error.what());
}

Image RunReader::picture(const StoredQuantity& pictures, std::size_t row) const try {
  const h5::Id dataset = h5::openDataset(opened_->group, pictures.name);
  std::vector<hsize_t> size = h5::shapeOf(dataset);
  constexpr hsize_t most_px = 16384;
  if (size.size() != 4 || size[1] > most_px || size[2] > most_px || size[1] * size[2] == 0 || size[3] != 3 ||
      row >= size[0])
    throw RunError(pictures.name + " is no stack of pictures, expected frame_time x image_y x image_x x 3");
  size[0] = 1;
  Image image{static_cast<int>(size[2]), static_cast<int>(size[1]), {}};
  image.rgb.resize(size[1] * size[2] * size[3]);
  readBlock(dataset, pictures.name, {row, 0, 0, 0}, size, H5T_NATIVE_UCHAR, image.rgb.data());
  return image;
} catch (const RunError& error) {
  throw InputError(inFile(path_), error.what());
}

}  // namespace fissure
