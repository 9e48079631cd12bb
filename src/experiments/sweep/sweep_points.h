#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sweep/sweep_file.h"

namespace fissure {

/// The points of a sweep, each with the values of all axes. They are numbered in the order of their design
/// (in a grid the last axis is the fastest), without excluded ones. The same file gives the same points on
/// every machine: random numbers are Boost's, which are defined to the last bit.
class SweepPoints {
 public:
  SweepPoints() = default;  ///< no points
  /// Makes all points; their number should be checked first with designed().
  explicit SweepPoints(const SweepSettings& settings);
  /// Takes existing points: `points` has, point by point, the index in `texts` of the value of each axis.
  SweepPoints(std::vector<std::string> paths, std::vector<std::string> texts, std::vector<std::size_t> points)
      : paths_(std::move(paths)), texts_(std::move(texts)), points_(std::move(points)) {}

  /// Paths of the axes in the order of the file; zipped axes follow each other.
  const std::vector<std::string>& paths() const { return paths_; }
  std::size_t size() const { return paths_.empty() ? 0 : points_.size() / paths_.size(); }
  /// The value of axis `axis` at a point, as YAML.
  const std::string& value(std::size_t point, std::size_t axis) const {
    return texts_[points_[point * paths_.size() + axis]];
  }

  const std::vector<std::string>& texts() const { return texts_; }     ///< all values that occur
  const std::vector<std::size_t>& indices() const { return points_; }  ///< [point][axis] index in texts()

  /// Number of points of the design, including excluded ones; a double, because that of a grid may exceed the
  /// range of integers.
  static double designed(const SweepSettings& settings);

 private:
  void makeGrid(const SweepSettings& settings);
  void makeSamples(const SweepSettings& settings);
  void addUnlessExcluded(const SweepSettings& settings, const std::vector<std::size_t>& texts);

  std::vector<std::string> paths_;
  std::vector<std::string> texts_;
  std::vector<std::size_t> points_;  // [point][axis] index in texts_
};

}  // namespace fissure
