#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "base/record.h"

namespace fissure {

/// A missing value.
inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// The axis "xyz" of vectors.
RecordAxis xyzAxis();

/// Writes x, y, z into three columns of a row.
void writeVector(const Vec3& vector, std::size_t first_column, RecordRow& row);

/// A count as a scalar of the summary; NaN, not 0, when nothing was counted.
SummaryValue countOrMissing(const std::string& name, bool counted, long long count);

/// Running maximum of a series. NaN before the first value, and always after any NaN, because the maximum is
/// then unknown.
class RunningMax {
 public:
  void add(double value) {
    if (!started_ || std::isnan(value) || value > value_) value_ = value;
    started_ = true;
  }
  double value() const { return value_; }

 private:
  double value_ = kMissing;
  bool started_ = false;
};

/// Roughness of an evenly sampled series: RMS of its second difference f[i-1] - 2 f[i] + f[i+1] over its own
/// RMS (measure/METHOD.md 5). Both means are over all available values. NaN with fewer than three values, for
/// a series of zeros, and after any NaN.
class Roughness {
 public:
  Roughness() = default;
  /// The roughness of `count` values of which these sums are known. No value can be added to it.
  static Roughness ofSums(long long count, double sum_of_squares, double sum_of_squared_differences) {
    Roughness roughness;
    roughness.sum_of_squares_ = sum_of_squares;
    roughness.sum_of_squared_differences_ = sum_of_squared_differences;
    roughness.count_ = count;
    return roughness;
  }
  void add(double value) {
    ++count_;
    sum_of_squares_ += value * value;
    const double difference = before_last_ - 2 * last_ + value;
    if (count_ >= 3) sum_of_squared_differences_ += difference * difference;
    before_last_ = last_;
    last_ = value;
  }
  double value() const { return of({this, 1}); }
  /// The joint roughness of several series of the same length: both means are over all their values.
  static double of(std::span<const Roughness> series);

 private:
  double before_last_ = 0;
  double last_ = 0;
  double sum_of_squares_ = 0;
  double sum_of_squared_differences_ = 0;
  long long count_ = 0;
};

/// The percentile by nearest rank: the smallest of `values` that at least `percent` per cent of them do not
/// exceed; NaN without values.
double percentile(std::vector<double> values, double percent);

}  // namespace fissure
