#pragma once

#include <array>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Integer coordinates along x, y and z of a grid point, or of a cell, by its corner with the least
/// coordinates.
using GridPoint = std::array<int, 3>;

/// The points of a box cut into cells. Those on its surface are numbered first, then those inside, both along
/// x, then y, then z.
class BoxGrid {
 public:
  /// `cells`: numbers of cells along x, y and z, each > 0.
  explicit BoxGrid(const std::array<int, 3>& cells);

  const std::array<int, 3>& cells() const { return cells_; }
  /// The number of a point.
  int index(const GridPoint& point) const { return index_[place(point)]; }

  /// The points of the surface, in the order of their numbers.
  const std::vector<GridPoint>& surface() const { return surface_; }
  /// The points inside, whose numbers follow.
  const std::vector<GridPoint>& inside() const { return inside_; }

  /// Position of a point, metres, in a box with full edge lengths `size_m` centred on the origin. Positions
  /// of mirror-symmetric points are mirror-symmetric to the last bit.
  Vec3 position_m(const GridPoint& point, const Vec3& size_m) const;

 private:
  std::size_t place(const GridPoint& point) const;

  std::array<int, 3> cells_;
  std::vector<int> index_;  ///< [point, x fastest] its number
  std::vector<GridPoint> surface_, inside_;
};

}  // namespace fissure
