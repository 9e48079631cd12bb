#include "mesh/weld.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace fissure {
namespace {

/// Vertex indices in groups; a group's root is its lowest index.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }
  int root(int i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void unite(int a, int b) {
    a = root(a);
    b = root(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parents_;
};

using Cell = std::array<double, 3>;

/// Cells so small that all vertices of one are within the tolerance, and the vertices in them.
std::map<Cell, std::vector<int>> sortIntoCells(const std::vector<Vec3>& vertices, double side) {
  std::map<Cell, std::vector<int>> cells;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!vertices[i].allFinite()) continue;
    Cell cell;
    // Adding 0 makes 0 of -0, which a map would take for the same but a reader of this might not.
    for (int k = 0; k < 3; ++k)
      cell[k] = (side > 0 ? std::floor(vertices[i][k] / side) : vertices[i][k]) + 0.0;
    cells[cell].push_back(static_cast<int>(i));
  }
  return cells;
}

/// Unites two groups when any two of their vertices are near.
void uniteNear(const std::vector<Vec3>& vertices, const std::vector<int>& a, const std::vector<int>& b,
               double tolerance, Groups& groups) {
  if (groups.root(a.front()) == groups.root(b.front())) return;
  for (const int i : a)
    for (const int j : b)
      if ((vertices[i] - vertices[j]).norm() <= tolerance) return groups.unite(i, j);
}

void uniteAcrossCells(const std::vector<Vec3>& vertices, const std::map<Cell, std::vector<int>>& cells,
                      double tolerance, Groups& groups) {
  constexpr int reach = 2;  // cells are tolerance / sqrt(3) wide
  for (const auto& [cell, members] : cells)
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = -reach; z <= reach; ++z) {
          const auto other = cells.find({cell[0] + x, cell[1] + y, cell[2] + z});
          if (other != cells.end() && cell < other->first)
            uniteNear(vertices, members, other->second, tolerance, groups);
        }
}

}  // namespace

void weldVertices(TriangleMesh& mesh, double tolerance) {
  const auto cells = sortIntoCells(mesh.vertices_m, tolerance / std::sqrt(3.0));
  Groups groups(mesh.vertices_m.size());
  for (const auto& [cell, members] : cells)
    for (const int i : members) groups.unite(members.front(), i);
  if (tolerance > 0) uniteAcrossCells(mesh.vertices_m, cells, tolerance, groups);
  std::vector<int> renumbered(mesh.vertices_m.size());
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    const int root = groups.root(static_cast<int>(i));
    if (root != static_cast<int>(i)) {
      renumbered[i] = renumbered[root];
      continue;
    }
    renumbered[i] = static_cast<int>(kept.size());
    kept.push_back(mesh.vertices_m[i]);
  }
  mesh.vertices_m = std::move(kept);
  for (Face& face : mesh.faces)
    for (int& v : face) v = renumbered[v];
}

}  // namespace fissure
