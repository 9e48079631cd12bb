#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "base/record.h"
#include "hdf5/h5.h"

namespace fissure {

/// One axis of a dataset, with the name of the coordinate in the same group that describes it.
struct Dimension {
  std::string name;
  hsize_t length = 0;
  bool grows = false;  ///< the axis starts empty and grows; `length` is then that of one chunk
};

/// The description of a dataset, for people and for netCDF readers.
struct DatasetSpec {
  std::string name;
  std::string units;
  std::string long_name;
  ValueType type = ValueType::real;
  std::vector<Dimension> dimensions;
};

/// A dataset with one growing axis, written slice by slice.
class GrowingDataset {
 public:
  GrowingDataset(h5::Id dataset, const DatasetSpec& spec, h5::Id text_type = {});

  /// Appends `count` slices along the growing axis. `data` holds values of the dataset's type (double, int64,
  /// uint8, or const char* for texts) in the order of the dataset's axes. Throws RunError when writing fails.
  void append(const void* data, hsize_t count);

 private:
  h5::Id dataset_;
  std::string name_;
  h5::Id text_type_;  // only for datasets of texts
  hid_t memory_type_;
  std::size_t growing_axis_ = 0;
  std::vector<hsize_t> shape_;
};

/// Fills a new group. Its datasets get units, a long name and, in the attribute `dimensions`, the names of
/// their axes; each axis must get a coordinate in the same group. attachScales() later turns the names into
/// dimension scales. Scales attached here would not survive being copied to another file, because HDF5 1.10
/// does not update references that are stored in attributes.
class GroupBuilder {
 public:
  /// Creates the group. Throws RunError when that fails.
  GroupBuilder(hid_t parent, const std::string& name);
  /// For an existing group.
  explicit GroupBuilder(h5::Id group) : group_(std::move(group)) {}

  const h5::Id& id() const { return group_; }

  /// Adds a coordinate with one name per index. Throws std::logic_error when the axis exists with other
  /// names.
  void addLabels(const std::string& axis, const std::vector<std::string>& labels);
  /// Adds a coordinate 0 .. length - 1.
  void addIndex(const std::string& axis, hsize_t length);

  /// Adds a dataset with one growing axis. This and the following functions throw std::logic_error when the
  /// name is taken.
  GrowingDataset addGrowing(const DatasetSpec& spec);
  /// Add a complete dataset; whole numbers need `spec.type` count.
  void addFixed(const DatasetSpec& spec, const std::vector<std::int64_t>& values);
  void addFixed(const DatasetSpec& spec, const std::vector<double>& values);
  /// `spec` has the axes (n, xyz).
  void addFixed(const DatasetSpec& spec, const std::vector<Vec3>& values);
  /// As addFixed() for at least one whole number, stored in one chunk, shuffled and deflated.
  void addFixedPacked(const DatasetSpec& spec, const std::vector<std::int64_t>& values);
  /// Adds a growing dataset of uint8 pictures with one frame per chunk, deflated.
  GrowingDataset addPictures(const DatasetSpec& spec);
  /// Adds a growing dataset of numbers, shuffled and deflated.
  GrowingDataset addPacked(const DatasetSpec& spec);
  /// Adds a growing dataset of variable-length UTF-8 texts; `spec.type` must be count, as no value is ever
  /// missing.
  GrowingDataset addTexts(const DatasetSpec& spec);

 private:
  enum class Packing { none, deflate, shuffle_and_deflate };
  static h5::Id creationProperties(const DatasetSpec& spec, Packing packing);
  h5::Id create(const DatasetSpec& spec, hid_t type, Packing packing = Packing::none);
  void describe(hid_t dataset, const DatasetSpec& spec) const;

  h5::Id group_;
  std::map<std::string, std::vector<std::string>> labels_;  ///< names of the axes that have them
};

/// The attribute that names a dataset's axes until attachScales() replaces it.
inline constexpr const char* dimensions_attribute = "dimensions";

/// The axes named in a dataset's `dimensions` attribute; empty when it has none.
std::vector<std::string> dimensionNames(hid_t dataset);

/// Turns the `dimensions` attributes of a group and all groups below into dimension scales of the same group.
/// Throws RunError when an axis has no coordinate beside its dataset.
void attachScales(hid_t group);

}  // namespace fissure
