#include "mesh/primitives.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <unordered_map>

namespace fissure {
namespace {

/// Splits triangles in four; the midpoint of an edge is made once and shared by its two triangles.
class Splitter {
 public:
  Splitter(TriangleMesh& mesh, double radius_m) : mesh_(mesh), radius_m_(radius_m) {}

  void split() {
    midpoints_.clear();
    std::vector<Face> finer;
    finer.reserve(4 * mesh_.faces.size());
    for (const auto& [a, b, c] : mesh_.faces) {
      const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh_.faces = std::move(finer);
  }

 private:
  int midpoint(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const std::uint64_t edge = (static_cast<std::uint64_t>(low) << 32) |
                               static_cast<std::uint64_t>(static_cast<std::uint32_t>(high));
    const auto [found, is_new] = midpoints_.try_emplace(edge, static_cast<int>(mesh_.vertices_m.size()));
    if (is_new) {
      const auto& vertices = mesh_.vertices_m;
      mesh_.vertices_m.push_back(radius_m_ * Vec3(vertices[low] + vertices[high]).normalized());
    }
    return found->second;
  }

  TriangleMesh& mesh_;
  double radius_m_;
  std::unordered_map<std::uint64_t, int> midpoints_;
};

}  // namespace

TriangleMesh makeSphere(double radius_m, int subdivisions) {
  assert(radius_m > 0 && subdivisions >= 0);
  const double r = radius_m;
  TriangleMesh sphere;
  sphere.vertices_m = {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  sphere.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  Splitter splitter(sphere, radius_m);
  for (int level = 0; level < subdivisions; ++level) splitter.split();
  return sphere;
}

TriangleMesh makeBox(const Vec3& size_m) {
  assert(size_m.minCoeff() > 0);
  TriangleMesh box;
  // Bit 0 of the index is the side in x, bit 1 in y, bit 2 in z.
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 side((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5, (corner & 4) ? 0.5 : -0.5);
    box.vertices_m.push_back(side.cwiseProduct(size_m));
  }
  box.faces = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
               {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return box;
}

}  // namespace fissure
