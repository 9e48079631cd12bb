#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sweep/sweep_file.h"

namespace fissure {

/// The points of a sweep: for each the values of all axes. Numbered as their design makes them, the last axis
/// of a grid fastest, excluded ones left out. The same file gives the same points everywhere: random numbers
/// are Boost's, which are defined to the last bit.
class SweepPoints {
 public:
  SweepPoints() = default;  ///< none
  /// Makes them all. Look at designed() first.
  explicit SweepPoints(const SweepSettings& settings);
  /// Those that others made: `points` holds, row by row, which of `texts` each axis has.
  SweepPoints(std::vector<std::string> paths, std::vector<std::string> texts, std::vector<std::size_t> points)
      : paths_(std::move(paths)), texts_(std::move(texts)), points_(std::move(points)) {}

  /// Paths of the axes, in the order of the file, zipped ones after each other.
  const std::vector<std::string>& paths() const { return paths_; }
  std::size_t size() const { return paths_.empty() ? 0 : points_.size() / paths_.size(); }
  /// YAML of the value of axis `axis` at a point.
  const std::string& value(std::size_t point, std::size_t axis) const {
    return texts_[points_[point * paths_.size() + axis]];
  }

  const std::vector<std::string>& texts() const { return texts_; }     ///< those that value() picks from
  const std::vector<std::size_t>& indices() const { return points_; }  ///< row by row: of texts()

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
