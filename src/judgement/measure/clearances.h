#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace fissure {

/// Lower and upper bounds of the distances of points from a surface, kept while both move, so that points
/// which are far away, or surely not the deepest, need no search in every step. Metres.
class Clearances {
 public:
  explicit Clearances(std::size_t points) : bounds_(points) {}

  /// Widens all bounds: points and surface have moved relative to each other by at most `way_m`, and by at
  /// most `near_way_m` where the surface was so near that a lower bound may have to fall.
  void move(double near_way_m, double way_m) {
    near_way_m_ += near_way_m;
    way_m_ += way_m;
  }
  /// A lower bound of the point's distance; 0 or less: nothing is known.
  double atLeast_m(std::size_t point) const { return bounds_[point].until_m - near_way_m_; }
  /// An upper bound; infinite: nothing is known.
  double atMost_m(std::size_t point) const { return bounds_[point].from_m + way_m_; }
  /// Set the bounds of a point's present distance.
  void noteAtLeast(std::size_t point, double distance_m) {
    bounds_[point].until_m = near_way_m_ + distance_m;
  }
  void noteAtMost(std::size_t point, double distance_m) { bounds_[point].from_m = distance_m - way_m_; }
  void forget() {
    std::fill(bounds_.begin(), bounds_.end(), Bounds());
    near_way_m_ = way_m_ = 0;
  }

 private:
  struct Bounds {
    double until_m =
        -std::numeric_limits<double>::infinity();  // value of near_way_m_ up to which it cannot touch
    double from_m = std::numeric_limits<double>::infinity();  // upper bound of its distance minus way_m_
  };
  double near_way_m_ = 0, way_m_ = 0;  // sums of relative displacements since forget()
  std::vector<Bounds> bounds_;
};

}  // namespace fissure
