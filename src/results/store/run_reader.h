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
  std::string name;  ///< "law", "vertex", "xyz"
  std::size_t length = 0;
  std::vector<std::string> labels;  ///< one an index; empty where the axis only counts

  bool operator==(const StoredAxis&) const = default;
};

/// A numeric dataset of a run: rows over its growing axis, where it has one.
struct StoredQuantity {
  std::string name;  ///< below the pipeline's group: "force", "tools/spatula/vertices"
  std::string units;
  std::string type;      ///< "f64", "i64", "u8"
  std::string row_axis;  ///< "time", "snapshot_time" or "frame_time"; empty: one row
  std::size_t rows = 1;
  std::vector<StoredAxis> axes;  ///< beside the rows, slowest first

  std::size_t columns() const;  ///< values in a row
};

/// The datasets of one pipeline's run in a result file, without timing/ and without views of other datasets.
/// Everything here throws InputError about the file when it is missing, damaged or no result.
class RunReader {
 public:
  RunReader(const std::filesystem::path& file, const std::string& pipeline);
  RunReader(RunReader&&) noexcept;
  ~RunReader();

  const std::filesystem::path& file() const { return path_; }
  /// In the order of the file.
  const std::vector<StoredQuantity>& quantities() const { return quantities_; }
  /// Of that name; null when there is none.
  const StoredQuantity* find(const std::string& name) const;

  /// `count` rows from `first` on, row by row, each in the order of `axes`; missing values are NaN.
  std::vector<double> rows(const StoredQuantity& quantity, std::size_t first, std::size_t count) const;
  std::vector<double> all(const StoredQuantity& quantity) const { return rows(quantity, 0, quantity.rows); }
  /// One row of a stack of pictures, "frames". Throws InputError too when `pictures` is none.
  Image picture(const StoredQuantity& pictures, std::size_t row) const;

 private:
  struct Opened;
  std::filesystem::path path_;
  std::unique_ptr<Opened> opened_;
  std::vector<StoredQuantity> quantities_;
};

}  // namespace fissure
