#pragma once

#include <limits>
#include <vector>

namespace fissure {

/// A quantity of one run over time. Times ascend, in seconds; values are in the unit of the quantity, NaN
/// where nothing was measured.
struct StudyCurve {
  std::vector<double> time_s;
  std::vector<double> values;

  bool empty() const { return time_s.empty(); }
  /// The largest magnitude; NaN where a value is NaN, or there is none.
  double peak() const;
};

/// How far a curve is from another one, in the unit of the quantity. All are NaN where the curves cannot be
/// compared.
struct CurveError {
  double rms = std::numeric_limits<double>::quiet_NaN();    ///< root of the mean square difference
  double worst = std::numeric_limits<double>::quiet_NaN();  ///< largest difference
  double peak = std::numeric_limits<double>::quiet_NaN();   ///< difference of the peaks
};

/// The value at a time between the first and the last, linear between neighbours; NaN outside.
double valueAt(const StudyCurve& curve, double time_s);

/// The error of `run` against `reference`, at the times of whichever has fewer, the other one linear between
/// its own. NaN where a value that is compared is NaN, or where one of the two ends earlier than the other by
/// more than a step of the coarser: a run that stopped is never near.
CurveError errorOf(const StudyCurve& run, const StudyCurve& reference);

}  // namespace fissure
