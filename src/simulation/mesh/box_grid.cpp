#include "mesh/box_grid.h"

#include <cassert>

namespace fissure {

BoxGrid::BoxGrid(const std::array<int, 3>& cells) : cells_(cells) {
  assert(cells[0] > 0 && cells[1] > 0 && cells[2] > 0);
  for (int k = 0; k <= cells[2]; ++k) {
    for (int j = 0; j <= cells[1]; ++j) {
      for (int i = 0; i <= cells[0]; ++i) {
        const bool inner = i > 0 && i < cells[0] && j > 0 && j < cells[1] && k > 0 && k < cells[2];
        (inner ? inside_ : surface_).push_back({i, j, k});
      }
    }
  }
  index_.resize(surface_.size() + inside_.size());
  int next = 0;
  for (const GridPoint& point : surface_) index_[place(point)] = next++;
  for (const GridPoint& point : inside_) index_[place(point)] = next++;
}

std::size_t BoxGrid::place(const GridPoint& point) const {
  const auto [i, j, k] = point;
  return static_cast<std::size_t>(i) +
         (static_cast<std::size_t>(cells_[0]) + 1) *
             (static_cast<std::size_t>(j) +
              (static_cast<std::size_t>(cells_[1]) + 1) * static_cast<std::size_t>(k));
}

Vec3 BoxGrid::position_m(const GridPoint& point, const Vec3& size_m) const {
  Vec3 side;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    side[axis] = (2 * point[a] - cells_[a]) / (2.0 * cells_[a]);
  }
  return side.cwiseProduct(size_m);
}

}  // namespace fissure
