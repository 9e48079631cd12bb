#include "contact/grid_nodes.h"

#include <algorithm>

namespace fissure {

namespace {
/// 0..1 over the edge of a face, both ends included; a single node stands in the middle.
double gridFraction(int index, int count) {
  return count == 1 ? 0.5 : static_cast<double>(index) / (count - 1);
}
}  // namespace

ToolNodes makeGridNodes(const Vec3& size_m, const std::array<int, 2>& resolution) {
  std::array<int, 3> axes = {0, 1, 2};  // longest, middle, shortest edge; equal edges keep x, y, z order
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size_m[a] > size_m[b]; });
  const auto [along, across, through] = axes;

  ToolNodes nodes;
  const int per_face = resolution[0] * resolution[1];
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i < resolution[0]; ++i) {
      for (int j = 0; j < resolution[1]; ++j) {
        Vec3 position = Vec3::Zero();
        position[along] = size_m[along] * (gridFraction(i, resolution[0]) - 0.5);
        position[across] = size_m[across] * (gridFraction(j, resolution[1]) - 0.5);
        position[through] = 0.5 * side * size_m[through];
        nodes.positions_m.push_back(position);
        nodes.normals.push_back(side * Vec3::Unit(through));
        const int index = i * resolution[1] + j;
        nodes.partners.push_back(side > 0 ? index + per_face : index);
        nodes.thicknesses_m.push_back(size_m[through]);
      }
    }
  }
  return nodes;
}

}  // namespace fissure
