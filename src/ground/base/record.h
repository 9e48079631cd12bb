#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace fissure {

/// An axis of a series beside time, such as "law", "xyz" or "tool".
struct RecordAxis {
  std::string name;
  std::vector<std::string> labels;  ///< one label per index; their number is the length of the axis
};

/// The kind of a value, which decides how it is stored.
enum class ValueType {
  real,   ///< double, NaN = missing
  count,  ///< int64
  flag,   ///< uint8
};

/// One time series of a run: the meaning of a few columns of the record.
struct Series {
  /// "m", "N", "1", "us" ...
  std::string name;  ///< name of the dataset; may start with "timing/"
  std::string units;
  std::string long_name;  ///< one line for people
  ValueType type = ValueType::real;
  /// Names of the axes beside time, slowest first; empty: one value per step.
  std::vector<std::string> axes = {};
  std::size_t first_column = 0;  ///< set by RecordLayout
  std::size_t columns = 1;       ///< set by RecordLayout
};

/// The columns of a record: the series of a run, in order. Only series that the scenario asks for are
/// present.
class RecordLayout {
 public:
  /// Declares an axis. Throws std::logic_error when the name is known with other labels.
  void addAxis(const RecordAxis& axis);
  /// Declares a series over declared axes and returns its first column. Throws std::logic_error on a
  /// duplicate name or an unknown axis.
  std::size_t add(Series series);

  const std::vector<RecordAxis>& axes() const { return axes_; }
  /// The axis of this name. Throws std::logic_error when there is none.
  const RecordAxis& axis(const std::string& name) const;
  const std::vector<Series>& series() const { return series_; }
  /// The series of this name, or null.
  const Series* find(const std::string& name) const;
  /// Number of columns of all series together.
  std::size_t columns() const { return columns_; }

 private:
  std::vector<RecordAxis> axes_;
  std::vector<Series> series_;
  std::size_t columns_ = 0;
};

/// One row of a record: all columns of one step. Counts and flags are exact in a double.
using RecordRow = std::vector<double>;

/// A quantity that a sweep keeps as curves over time steps that its runs share: one curve per run, or one per
/// run and force law.
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
  bool of_law = false;  ///< it depends on coefficients of force laws that move no tool
};
using Summary = std::vector<SummaryValue>;

}  // namespace fissure
