#pragma once

#include <array>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// A point, or the corner of least coordinates of a cell, of a grid of cells: counts along x, y and z.
using GridPoint = std::array<int, 3>;

/// The points of a box cut into cells, numbered along x, then y, then z: those of its surface first, then
/// those inside.
class BoxGrid {
 public:
  /// `cells` along x, y and z, each > 0.
  explicit BoxGrid(const std::array<int, 3>& cells);

  const std::array<int, 3>& cells() const { return cells_; }
  int index(const GridPoint& point) const { return index_[place(point)]; }

  /// The points of the surface, in the order of their numbers.
  const std::vector<GridPoint>& surface() const { return surface_; }
  /// The points inside, which follow.
  const std::vector<GridPoint>& inside() const { return inside_; }

  /// Where a point is in a box of full edge lengths `size_m` centred on the origin; points that mirror each
  /// other are at places that do so to the last bit.
  Vec3 position_m(const GridPoint& point, const Vec3& size_m) const;

 private:
  std::size_t place(const GridPoint& point) const;

  std::array<int, 3> cells_;
  std::vector<int> index_;  ///< of each point, x fastest
  std::vector<GridPoint> surface_, inside_;
};

}  // namespace fissure
