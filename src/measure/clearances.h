#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace fissure {

/// How far points at least are from a surface, kept while both move: what is far away needs no look in every
/// step. Metres.
class Clearances {
 public:
  explicit Clearances(std::size_t points) : until_m_(points, -std::numeric_limits<double>::infinity()) {}

  /// Point and surface have come closer by at most `way_m`, for every point.
  void approach(double way_m) { way_m_ += way_m; }
  /// A lower bound of the point's distance; not above 0: nothing is known.
  double atLeast_m(std::size_t point) const { return until_m_[point] - way_m_; }
  /// The point is at least `distance_m` away now.
  void note(std::size_t point, double distance_m) { until_m_[point] = way_m_ + distance_m; }
  void forget() {
    std::fill(until_m_.begin(), until_m_.end(), -std::numeric_limits<double>::infinity());
    way_m_ = 0;
  }

 private:
  double way_m_ = 0;             // since forget()
  std::vector<double> until_m_;  // the way on which the point may touch the surface
};

}  // namespace fissure
