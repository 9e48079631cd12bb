#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace fissure {

/// Between what bounds the distances of points from a surface are, kept while both move: what is far from it,
/// or surely not the farthest, needs no look in every step. Metres.
class Clearances {
 public:
  explicit Clearances(std::size_t points) : bounds_(points) {}

  /// Each point and the surface have moved by at most `way_m` against each other.
  void move(double way_m) { way_m_ += way_m; }
  /// A lower bound of the point's distance; not above 0: nothing is known.
  double atLeast_m(std::size_t point) const { return bounds_[point].until_m - way_m_; }
  /// An upper bound; infinite: nothing is known.
  double atMost_m(std::size_t point) const { return bounds_[point].from_m + way_m_; }
  void noteAtLeast(std::size_t point, double distance_m) { bounds_[point].until_m = way_m_ + distance_m; }
  void noteAtMost(std::size_t point, double distance_m) { bounds_[point].from_m = distance_m - way_m_; }
  void forget() {
    std::fill(bounds_.begin(), bounds_.end(), Bounds());
    way_m_ = 0;
  }

 private:
  struct Bounds {
    double until_m = -std::numeric_limits<double>::infinity();  // the way on which the point may touch
    double from_m = std::numeric_limits<double>::infinity();    // its distance, had it gone away all the way
  };
  double way_m_ = 0;  // since forget()
  std::vector<Bounds> bounds_;
};

}  // namespace fissure
