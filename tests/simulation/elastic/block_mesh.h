#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/tetrahedra.h"

namespace fissure {

enum class CellSplit { five, six };

struct BlockShape {
  std::array<int, 3> cells = {2, 2, 2};
  Vec3 size_m = {0.04, 0.04, 0.04};
  CellSplit split = CellSplit::five;
  /// How far vertices inside are moved at random, over half a cell: 0.4 leaves all volumes positive.
  double irregularity = 0;
};

/// Numbers between -1 and 1, the same on every machine.
class Random {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1;
  }
  Vec3 vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }

 private:
  std::uint64_t state_ = 7;
};

struct BlockMesh {
  TetrahedralMesh mesh;
  int surface_vertices = 0;

  std::vector<int> where(const std::function<bool(const Vec3&)>& holds) const {
    std::vector<int> found;
    for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v)
      if (holds(mesh.vertices_m[v])) found.push_back(static_cast<int>(v));
    return found;
  }
};

/// A block from the origin to size_m, its surface's vertices first.
inline BlockMesh makeBlock(const BlockShape& shape) {
  const auto [nx, ny, nz] = shape.cells;
  const auto inside = [&](int i, int j, int k) {
    return i > 0 && i < nx && j > 0 && j < ny && k > 0 && k < nz;
  };
  const auto at = [&](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };
  const Vec3 cell_m = shape.size_m.cwiseQuotient(Vec3(nx, ny, nz));
  BlockMesh block;
  Random random;
  std::vector<int> number(static_cast<std::size_t>((nx + 1) * (ny + 1) * (nz + 1)));
  for (const bool wanted : {false, true}) {
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
          if (inside(i, j, k) != wanted) continue;
          number[at(i, j, k)] = static_cast<int>(block.mesh.vertices_m.size());
          Vec3 position_m = cell_m.cwiseProduct(Vec3(i, j, k));
          if (wanted) position_m += 0.5 * shape.irregularity * cell_m.cwiseProduct(random.vector());
          block.mesh.vertices_m.push_back(position_m);
        }
    if (!wanted) block.surface_vertices = static_cast<int>(block.mesh.vertices_m.size());
  }
  // Corners of a cell are numbered x + 2 y + 4 z. Five: four corners cut off; neighbours are mirrored.
  using Cut = std::vector<Tetrahedron>;
  const Cut five = {{0, 1, 2, 4}, {3, 1, 2, 7}, {5, 1, 4, 7}, {6, 2, 4, 7}, {1, 2, 4, 7}};
  const Cut six = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (const Tetrahedron& cut : shape.split == CellSplit::five ? five : six) {
          const int mirror = shape.split == CellSplit::five ? (i + j + k) % 2 : 0;
          Tetrahedron corners;
          for (int c = 0; c < 4; ++c) {
            const int corner = cut[c] ^ mirror;
            corners[c] = number[at(i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2))];
          }
          const Vec3& a = block.mesh.vertices_m[corners[0]];
          const auto edge = [&](int c) -> Vec3 { return block.mesh.vertices_m[corners[c]] - a; };
          if (edge(1).dot(edge(2).cross(edge(3))) < 0) std::swap(corners[2], corners[3]);
          block.mesh.tetrahedra.push_back(corners);
        }
  return block;
}

}  // namespace fissure
