#include "hdf5/group_builder.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "base/error.h"

namespace fissure {

namespace {

hid_t nativeType(ValueType type) {
  switch (type) {
    case ValueType::count:
      return H5T_NATIVE_INT64;
    case ValueType::flag:
      return H5T_NATIVE_UINT8;
    case ValueType::real:
      break;
  }
  return H5T_NATIVE_DOUBLE;
}

// CF asks coordinates not to have missing values; the coordinate of an axis bears the axis's name.
bool isCoordinate(const DatasetSpec& spec) {
  return spec.dimensions.size() == 1 && spec.dimensions.front().name == spec.name;
}

void describeFlags(hid_t dataset, const std::string& name) {
  std::string meanings = "false true";
  if (name == "node_state") meanings = "free feasible infeasible capped";
  if (name == "vertex_contact") meanings = "free contact";
  const auto count = 1 + std::count(meanings.begin(), meanings.end(), ' ');
  std::vector<std::uint8_t> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), std::uint8_t{0});
  h5::setAttribute(dataset, "flag_values", values);
  h5::setAttribute(dataset, "flag_meanings", meanings);
}

std::string joinedNames(const std::vector<Dimension>& dimensions) {
  std::string names;
  for (const Dimension& dimension : dimensions) names += (names.empty() ? "" : " ") + dimension.name;
  return names;
}

h5::Id spaceOf(const DatasetSpec& spec) {
  std::vector<hsize_t> shape;
  std::vector<hsize_t> limit;
  for (const Dimension& dimension : spec.dimensions) {
    shape.push_back(dimension.grows ? 0 : dimension.length);
    limit.push_back(dimension.grows ? H5S_UNLIMITED : dimension.length);
  }
  const int rank = static_cast<int>(shape.size());
  return h5::Id(H5Screate_simple(rank, shape.data(), limit.data()), H5Sclose, "cannot create dataset",
                spec.name);
}

}  // namespace

GrowingDataset::GrowingDataset(h5::Id dataset, const DatasetSpec& spec, h5::Id text_type)
    : dataset_(std::move(dataset)),
      name_(spec.name),
      text_type_(std::move(text_type)),
      memory_type_(text_type_.valid() ? static_cast<hid_t>(text_type_) : nativeType(spec.type)) {
  for (const Dimension& dimension : spec.dimensions) {
    if (dimension.grows) growing_axis_ = shape_.size();
    shape_.push_back(dimension.grows ? 0 : dimension.length);
  }
}

void GrowingDataset::append(const void* data, hsize_t count) {
  const char* doing = "cannot write dataset";
  std::vector<hsize_t> start(shape_.size(), 0);
  std::vector<hsize_t> size = shape_;
  start[growing_axis_] = shape_[growing_axis_];
  size[growing_axis_] = count;
  shape_[growing_axis_] += count;
  h5::check(H5Dset_extent(dataset_, shape_.data()), doing, name_);
  if (std::find(size.begin(), size.end(), hsize_t{0}) != size.end()) return;
  const h5::Id file_space(H5Dget_space(dataset_), H5Sclose, doing, name_);
  h5::check(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
            doing, name_);
  const int rank = static_cast<int>(size.size());
  const h5::Id memory_space(H5Screate_simple(rank, size.data(), nullptr), H5Sclose, doing, name_);
  h5::check(H5Dwrite(dataset_, memory_type_, memory_space, file_space, H5P_DEFAULT, data), doing, name_);
}

GroupBuilder::GroupBuilder(hid_t parent, const std::string& name) : group_(h5::createGroup(parent, name)) {}

h5::Id GroupBuilder::creationProperties(const DatasetSpec& spec, Packing packing) {
  const char* doing = "cannot prepare dataset";
  h5::Id creation = h5::datasetProperties();
  if (spec.type == ValueType::real) {
    const double missing = std::numeric_limits<double>::quiet_NaN();
    h5::check(H5Pset_fill_value(creation, H5T_NATIVE_DOUBLE, &missing), doing, spec.name);
  }
  const auto grows = [](const Dimension& dimension) { return dimension.grows; };
  if (packing != Packing::none || std::any_of(spec.dimensions.begin(), spec.dimensions.end(), grows)) {
    std::vector<hsize_t> chunk;
    for (const Dimension& dimension : spec.dimensions)
      chunk.push_back(std::max<hsize_t>(1, dimension.length));
    h5::check(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), doing, spec.name);
  }
  if (packing == Packing::shuffle_and_deflate) h5::check(H5Pset_shuffle(creation), doing, spec.name);
  if (packing != Packing::none) h5::check(H5Pset_deflate(creation, 1), doing, spec.name);
  return creation;
}

h5::Id GroupBuilder::create(const DatasetSpec& spec, hid_t type, Packing packing) {
  if (h5::exists(group_, spec.name)) throw std::logic_error("result dataset made twice: " + spec.name);
  const h5::Id space = spaceOf(spec);
  const h5::Id creation = creationProperties(spec, packing);
  h5::Id dataset(H5Dcreate2(group_, spec.name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                 H5Dclose, "cannot create dataset", spec.name);
  describe(dataset, spec);
  return dataset;
}

void GroupBuilder::describe(hid_t dataset, const DatasetSpec& spec) const {
  h5::setAttribute(dataset, "units", spec.units);
  h5::setAttribute(dataset, "long_name", spec.long_name);
  if (spec.type == ValueType::real && !isCoordinate(spec)) {
    h5::setAttribute(dataset, "_FillValue", std::numeric_limits<double>::quiet_NaN());
  }
  if (spec.type == ValueType::flag && spec.dimensions.back().name != "channel") {
    describeFlags(dataset, spec.name);
  }
  h5::setAttribute(dataset, dimensions_attribute, joinedNames(spec.dimensions));
}

void GroupBuilder::addLabels(const std::string& axis, const std::vector<std::string>& labels) {
  const auto known = labels_.find(axis);
  if (known != labels_.end() && known->second == labels) return;
  if (known != labels_.end() || h5::exists(group_, axis)) {
    throw std::logic_error("result axis made twice: " + axis);
  }
  labels_[axis] = labels;
  const DatasetSpec spec{axis, "1", "name of each " + axis, ValueType::count, {{axis, labels.size()}}};
  const h5::Id type = h5::textType();
  const h5::Id dataset = create(spec, type);
  std::vector<const char*> pointers;
  for (const std::string& label : labels) pointers.push_back(label.c_str());
  h5::check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, h5::transferOf(type), pointers.data()),
            "cannot write dataset", axis);
}

void GroupBuilder::addIndex(const std::string& axis, hsize_t length) {
  std::vector<std::int64_t> values(length);
  std::iota(values.begin(), values.end(), std::int64_t{0});
  addFixed({axis, "1", "index of each " + axis, ValueType::count, {{axis, length}}}, values);
}

GrowingDataset GroupBuilder::addGrowing(const DatasetSpec& spec) {
  return GrowingDataset(create(spec, nativeType(spec.type)), spec);
}

GrowingDataset GroupBuilder::addPictures(const DatasetSpec& spec) {
  return GrowingDataset(create(spec, nativeType(spec.type), Packing::deflate), spec);
}

GrowingDataset GroupBuilder::addPacked(const DatasetSpec& spec) {
  return GrowingDataset(create(spec, nativeType(spec.type), Packing::shuffle_and_deflate), spec);
}

GrowingDataset GroupBuilder::addTexts(const DatasetSpec& spec) {
  h5::Id type = h5::textType();
  h5::Id dataset = create(spec, type);
  return GrowingDataset(std::move(dataset), spec, std::move(type));
}

void GroupBuilder::addFixed(const DatasetSpec& spec, const std::vector<std::int64_t>& values) {
  const h5::Id dataset = create(spec, nativeType(spec.type));
  h5::check(H5Dwrite(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "cannot write dataset", spec.name);
}

void GroupBuilder::addFixed(const DatasetSpec& spec, const std::vector<double>& values) {
  const h5::Id dataset = create(spec, nativeType(spec.type));
  h5::check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "cannot write dataset", spec.name);
}

void GroupBuilder::addFixed(const DatasetSpec& spec, const std::vector<Vec3>& values) {
  std::vector<double> numbers;
  for (const Vec3& value : values) numbers.insert(numbers.end(), value.data(), value.data() + 3);
  addFixed(spec, numbers);
}

void GroupBuilder::addFixedPacked(const DatasetSpec& spec, const std::vector<std::int64_t>& values) {
  const h5::Id dataset = create(spec, nativeType(spec.type), Packing::shuffle_and_deflate);
  h5::check(H5Dwrite(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "cannot write dataset", spec.name);
}

std::vector<std::string> dimensionNames(hid_t dataset) {
  std::istringstream words(h5::textAttribute(dataset, dimensions_attribute));
  std::vector<std::string> names;
  for (std::string name; words >> name;) names.push_back(name);
  return names;
}

void attachScales(hid_t group) {
  std::vector<std::string> datasets;
  for (const std::string& name : h5::childNames(group)) {
    const h5::Id child = h5::openObject(group, name);
    if (h5::isGroup(child)) {
      attachScales(child);
      continue;
    }
    datasets.push_back(name);
    if (dimensionNames(child) != std::vector<std::string>{name}) continue;
    h5::check(H5DSset_scale(child, name.c_str()), "cannot make a scale of", name);
    h5::removeAttribute(child, dimensions_attribute);
  }
  for (const std::string& name : datasets) {
    const h5::Id dataset = h5::openDataset(group, name);
    const std::vector<std::string> axes = dimensionNames(dataset);
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      const h5::Id scale = h5::openDataset(group, axes[axis]);
      h5::check(H5DSattach_scale(dataset, scale, static_cast<unsigned>(axis)), "cannot attach a scale to",
                name);
    }
    h5::removeAttribute(dataset, dimensions_attribute);
  }
}

}  // namespace fissure
