#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/image.h"

namespace fissure {

/// One axis of a stored quantity.
struct StoredAxis {
  /// "law", "vertex", "xyz".
  std::string name;
  std::size_t length = 0;
  std::vector<std::string> labels;  ///< one per index; empty for an axis without names

  bool operator==(const StoredAxis&) const = default;
};

/// A numeric dataset of a run, with one row per index of its growing axis, or a single row without one.
struct StoredQuantity {
  /// Path below the run's group: "force", "tools/spatula/vertices".
  std::string name;
  std::string units;
  /// "f64", "i64", "u8".
  std::string type;
  /// "time", "snapshot_time" or "frame_time"; empty: one row.
  std::string row_axis;
  std::size_t rows = 1;
  std::vector<StoredAxis> axes;  ///< axes other than that of the rows, slowest first

  std::size_t columns() const;  ///< number of values in a row
};

/// Reads the datasets of one run in a result file, without timing/ and without views of other datasets. All
/// functions throw InputError about the file when it is missing, damaged or no result.
class RunReader {
 public:
  RunReader(const std::filesystem::path& file, const std::string& pipeline);
  RunReader(RunReader&&) noexcept;
  ~RunReader();

  const std::filesystem::path& file() const { return path_; }
  /// All quantities, in the order of the file.
  const std::vector<StoredQuantity>& quantities() const { return quantities_; }
  /// The quantity of that name; null when there is none.
  const StoredQuantity* find(const std::string& name) const;

  /// The values of `count` rows from `first` on, row by row, each in the order of `axes`; missing values are
  /// NaN.
  std::vector<double> rows(const StoredQuantity& quantity, std::size_t first, std::size_t count) const;
  std::vector<double> all(const StoredQuantity& quantity) const { return rows(quantity, 0, quantity.rows); }
  /// One picture of the quantity "frames". Throws InputError also when `pictures` holds no pictures.
  Image picture(const StoredQuantity& pictures, std::size_t row) const;

 private:
  struct Opened;
  std::filesystem::path path_;
  std::unique_ptr<Opened> opened_;
  std::vector<StoredQuantity> quantities_;
};

}  // namespace fissure
