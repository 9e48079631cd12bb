#include "contact/grid_nodes.h"

#include <algorithm>
#include <cmath>

namespace fissure {

namespace {
/// 0..1 over the edge of a face, both ends included; a single node stands in the middle.
double gridFraction(int index, int count) {
  return count == 1 ? 0.5 : static_cast<double>(index) / (count - 1);
}

/// Nodes on the two faces of a box across `through`; counts along the two other axes.
void addFacePair(const Vec3& size_m, int along, int across, const std::array<int, 2>& counts,
                 ToolNodes& nodes) {
  const int through = 3 - along - across;
  const int first = nodes.size(), per_face = counts[0] * counts[1];
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i < counts[0]; ++i) {
      for (int j = 0; j < counts[1]; ++j) {
        Vec3 position = Vec3::Zero();
        position[along] = size_m[along] * (gridFraction(i, counts[0]) - 0.5);
        position[across] = size_m[across] * (gridFraction(j, counts[1]) - 0.5);
        position[through] = 0.5 * side * size_m[through];
        nodes.positions_m.push_back(position);
        nodes.normals.push_back(side * Vec3::Unit(through));
        const int index = first + i * counts[1] + j;
        nodes.partners.push_back(side > 0 ? index + per_face : index);
        nodes.thicknesses_m.push_back(size_m[through]);
      }
    }
  }
}

/// How many nodes cover a length at most as far apart as `count` of them cover `of_m`.
int countFor(double length_m, double of_m, int count) {
  if (count == 1) return 1;
  return 1 + static_cast<int>(std::ceil(length_m * (count - 1) / of_m * (1 - 1e-12)));
}

}  // namespace

ToolNodes makeGridNodes(const Vec3& size_m, const std::array<int, 2>& resolution, bool narrow_faces) {
  std::array<int, 3> axes = {0, 1, 2};  // longest, middle, shortest edge; equal edges keep x, y, z order
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size_m[a] > size_m[b]; });
  const auto [along, across, through] = axes;

  ToolNodes nodes;
  addFacePair(size_m, along, across, resolution, nodes);
  if (!narrow_faces) return nodes;
  addFacePair(size_m, along, through,
              {resolution[0], countFor(size_m[through], size_m[across], resolution[1])}, nodes);
  addFacePair(size_m, across, through,
              {resolution[1], countFor(size_m[through], size_m[along], resolution[0])}, nodes);
  return nodes;
}

}  // namespace fissure
