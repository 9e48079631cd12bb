#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/sweep_file.h"

namespace fissure {

/// The points of a sweep: for each the values of all axes. Numbered as their design makes them, the last axis
/// of a grid fastest, excluded ones left out. The same file gives the same points everywhere: random numbers
/// are Boost's, which are defined to the last bit.
class SweepPoints {
 public:
  /// Makes them all. Look at designed() first.
  explicit SweepPoints(const SweepSettings& settings);

  /// Paths of the axes, in the order of the file, zipped ones after each other.
  const std::vector<std::string>& paths() const { return paths_; }
  std::size_t size() const { return points_.size() / paths_.size(); }
  /// YAML of the value of axis `axis` at a point.
  const std::string& value(std::size_t point, std::size_t axis) const {
    return texts_[points_[point * paths_.size() + axis]];
  }

  /// How many points the design has, with those that are excluded: a double, because a grid may have more
  /// than fit anywhere.
  static double designed(const SweepSettings& settings);

 private:
  void makeGrid(const SweepSettings& settings);
  void makeSamples(const SweepSettings& settings);
  void addUnlessExcluded(const SweepSettings& settings, const std::vector<std::size_t>& texts);

  std::vector<std::string> paths_;
  std::vector<std::string> texts_;
  std::vector<std::size_t> points_;  // row by row: of texts_
};

}  // namespace fissure
