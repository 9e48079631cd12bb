#include "contact/grid_nodes.h"

#include <algorithm>

namespace fissure {

namespace {
/// 0..1 over the edge of a face, both ends included; a single node stands in the middle.
double gridFraction(int index, int count) {
  return count == 1 ? 0.5 : static_cast<double>(index) / (count - 1);
}

/// How a grid lies on two opposite faces: its axes, the axis through the box, and the nodes along the first
/// two.
struct Grid {
  int along = 0, across = 1, through = 2;
  std::array<int, 2> counts{};
};

void addPairs(const Vec3& size_m, const Grid& grid, ToolNodes& nodes) {
  const int first = nodes.size(), per_face = grid.counts[0] * grid.counts[1];
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i < grid.counts[0]; ++i) {
      for (int j = 0; j < grid.counts[1]; ++j) {
        Vec3 position = Vec3::Zero();
        position[grid.along] = size_m[grid.along] * (gridFraction(i, grid.counts[0]) - 0.5);
        position[grid.across] = size_m[grid.across] * (gridFraction(j, grid.counts[1]) - 0.5);
        position[grid.through] = 0.5 * side * size_m[grid.through];
        nodes.positions_m.push_back(position);
        nodes.normals.push_back(side * Vec3::Unit(grid.through));
        const int index = first + i * grid.counts[1] + j;
        nodes.partners.push_back(side > 0 ? index + per_face : index);
        nodes.thicknesses_m.push_back(size_m[grid.through]);
      }
    }
  }
}

}  // namespace

ToolNodes makeGridNodes(const Vec3& size_m, const std::array<int, 2>& resolution, int narrow_rows) {
  std::array<int, 3> axes = {0, 1, 2};  // longest, middle, shortest edge; equal edges keep x, y, z order
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size_m[a] > size_m[b]; });
  const auto [along, across, through] = axes;

  ToolNodes nodes;
  addPairs(size_m, {along, across, through, resolution}, nodes);
  nodes.all_sides = narrow_rows > 0;
  if (nodes.all_sides) {
    addPairs(size_m, {along, through, across, {resolution[0], narrow_rows}}, nodes);
    addPairs(size_m, {across, through, along, {resolution[1], narrow_rows}}, nodes);
  }
  return nodes;
}

}  // namespace fissure
