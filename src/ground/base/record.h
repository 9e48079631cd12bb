#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace fissure {

/// An axis beside time: "law" with its names, "xyz", "tool".
struct RecordAxis {
  std::string name;
  std::vector<std::string> labels;  ///< one an index; their number is the axis's length
};

/// What a value is, and so how it is stored.
enum class ValueType {
  real,   ///< double, NaN = missing
  count,  ///< int64
  flag,   ///< uint8
};

/// One time series of a run: the meaning of a few columns of the record.
struct Series {
  std::string name;       ///< of the dataset; may start with "timing/"
  std::string units;      ///< "m", "N", "1", "us" ...
  std::string long_name;  ///< one line for people
  ValueType type = ValueType::real;
  /// Names of RecordAxis beside time, slowest first; empty: one value a step.
  std::vector<std::string> axes = {};
  std::size_t first_column = 0;  ///< set by RecordLayout
  std::size_t columns = 1;       ///< set by RecordLayout
};

/// The columns of a record: which series a run has, in order. Only what the scenario asked for is present.
class RecordLayout {
 public:
  /// Declares an axis; the same name again must bring the same labels (std::logic_error otherwise).
  void addAxis(const RecordAxis& axis);
  /// Declares a series over declared axes and returns its first column. Throws std::logic_error on a
  /// duplicate name or an unknown axis.
  std::size_t add(Series series);

  const std::vector<RecordAxis>& axes() const { return axes_; }
  const RecordAxis& axis(const std::string& name) const;
  const std::vector<Series>& series() const { return series_; }
  const Series* find(const std::string& name) const;
  std::size_t columns() const { return columns_; }

 private:
  std::vector<RecordAxis> axes_;
  std::vector<Series> series_;
  std::size_t columns_ = 0;
};

/// One row: all columns of one step. Counts and flags are exact in a double.
using RecordRow = std::vector<double>;

/// A quantity that is kept of many runs over times that they share: a curve each run, or one each force law.
struct CurveQuantity {
  std::string name;
  std::string units;
  std::string long_name;
  bool per_law = false;
};

/// One scalar of a run's summary; the name carries the unit ("max_penetration_depth_m").
struct SummaryValue {
  std::string name;
  std::variant<double, long long, std::string> value;
  bool of_law = false;  ///< depends on the coefficients of force laws, where these move nothing
};
using Summary = std::vector<SummaryValue>;

}  // namespace fissure
