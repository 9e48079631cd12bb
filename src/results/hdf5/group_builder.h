#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "base/record.h"
#include "hdf5/h5.h"

namespace fissure {

/// One axis of a dataset; it is named after the coordinate of the same group that describes it.
struct Dimension {
  std::string name;
  hsize_t length = 0;
  bool grows = false;  ///< starts empty; `length` is then that of one chunk
};

/// What a dataset is, for people and for netCDF readers.
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

  /// Puts `count` slices behind those already there. `data` holds values of the dataset's own type (double,
  /// int64, uint8, or const char* where it is made of texts) in the dataset's own order, with `count` for the
  /// growing axis.
  void append(const void* data, hsize_t count);

 private:
  h5::Id dataset_;
  std::string name_;
  h5::Id text_type_;  // only of texts
  hid_t memory_type_;
  std::size_t growing_axis_ = 0;
  std::vector<hsize_t> shape_;
};

/// A group in the making. Its datasets carry units, a long name and, in the attribute `dimensions`, the names
/// of their axes; each axis must get a coordinate of its own in the same group. attachScales() later turns
/// the names into dimension scales: scales attached here would not survive being copied to another file,
/// because HDF5 1.10 does not rewrite references that are held in attributes.
class GroupBuilder {
 public:
  /// Creates the group; throws RunError.
  GroupBuilder(hid_t parent, const std::string& name);
  /// Of a group that is there.
  explicit GroupBuilder(h5::Id group) : group_(std::move(group)) {}

  const h5::Id& id() const { return group_; }

  /// Coordinate of names, one an index. The same axis again must bring the same names (std::logic_error
  /// otherwise).
  void addLabels(const std::string& axis, const std::vector<std::string>& labels);
  /// Coordinate 0 .. length - 1.
  void addIndex(const std::string& axis, hsize_t length);

  /// All of these throw std::logic_error when the name is taken.
  GrowingDataset addGrowing(const DatasetSpec& spec);
  /// Whole numbers; `spec.type` is count.
  void addFixed(const DatasetSpec& spec, const std::vector<std::int64_t>& values);
  void addFixed(const DatasetSpec& spec, const std::vector<double>& values);
  /// `spec` has the axes (n, xyz).
  void addFixed(const DatasetSpec& spec, const std::vector<Vec3>& values);
  /// As addFixed() of whole numbers, at least one, in one chunk, shuffled and deflated.
  void addFixedPacked(const DatasetSpec& spec, const std::vector<std::int64_t>& values);
  /// One frame a chunk, deflated; uint8.
  GrowingDataset addPictures(const DatasetSpec& spec);
  /// Numbers, a chunk shuffled and deflated.
  GrowingDataset addPacked(const DatasetSpec& spec);
  /// Variable-length UTF-8; `spec.type` is count, which is never missing.
  GrowingDataset addTexts(const DatasetSpec& spec);

 private:
  enum class Packing { none, deflate, shuffle_and_deflate };
  static h5::Id creationProperties(const DatasetSpec& spec, Packing packing);
  h5::Id create(const DatasetSpec& spec, hid_t type, Packing packing = Packing::none);
  void describe(hid_t dataset, const DatasetSpec& spec) const;

  h5::Id group_;
  std::map<std::string, std::vector<std::string>> labels_;  ///< of the axes that have names
};

/// The attribute that names a dataset's axes until attachScales() replaces it.
inline constexpr const char* dimensions_attribute = "dimensions";

/// The axes named in a dataset's `dimensions` attribute; empty when it has none.
std::vector<std::string> dimensionNames(hid_t dataset);

/// Turns the `dimensions` attributes of a group and all groups below into dimension scales of the same group.
/// Throws RunError when an axis has no coordinate beside its dataset.
void attachScales(hid_t group);

}  // namespace fissure
