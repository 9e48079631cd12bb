#include "mesh/primitives.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
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

/// Moves the halves of a sphere length_m apart along x, its ring in x = 0 with the left one. The ring, in the
/// order of the turn about x.
std::vector<int> drawApart(TriangleMesh& sphere, double length_m) {
  std::vector<int> ring;
  for (int v = 0; v < static_cast<int>(sphere.vertices_m.size()); ++v) {
    double& x_m = sphere.vertices_m[v].x();
    if (x_m == 0) ring.push_back(v);
    x_m += x_m > 0 ? length_m / 2 : -length_m / 2;
  }
  const auto angle = [&](int v) { return std::atan2(sphere.vertices_m[v].z(), sphere.vertices_m[v].y()); };
  std::sort(ring.begin(), ring.end(), [&](int a, int b) { return angle(a) < angle(b); });
  return ring;
}

/// In faces that reach into x > 0, the vertices of `right` take the places of those of `left`.
void giveRing(TriangleMesh& mesh, const std::vector<int>& left, const std::vector<int>& right) {
  std::vector<int> taken(mesh.vertices_m.size());
  std::iota(taken.begin(), taken.end(), 0);
  for (std::size_t j = 0; j < left.size(); ++j) taken[left[j]] = right[j];
  for (Face& face : mesh.faces) {
    if (std::none_of(face.begin(), face.end(), [&](int v) { return mesh.vertices_m[v].x() > 0; })) continue;
    for (int& v : face) v = taken[v];
  }
}

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

TriangleMesh makeCapsule(double radius_m, double length_m, int subdivisions, int rows) {
  assert(length_m > 0 && rows > 0);
  TriangleMesh capsule = makeSphere(radius_m, subdivisions);
  const std::vector<int> left = drawApart(capsule, length_m);
  const std::size_t around = left.size();
  std::vector<std::vector<int>> rings(static_cast<std::size_t>(rows) + 1, left);
  for (int row = 1; row <= rows; ++row) {
    for (int& v : rings[row]) {
      Vec3 vertex_m = capsule.vertices_m[v];
      vertex_m.x() = length_m * (static_cast<double>(row) / rows - 0.5);
      v = static_cast<int>(capsule.vertices_m.size());
      capsule.vertices_m.push_back(vertex_m);
    }
  }
  giveRing(capsule, left, rings.back());
  for (std::size_t row = 0; row + 1 < rings.size(); ++row) {
    for (std::size_t j = 0; j < around; ++j) {
      const int a = rings[row][j], b = rings[row][(j + 1) % around];
      const int c = rings[row + 1][j], d = rings[row + 1][(j + 1) % around];
      if ((row + j) % 2 == 0) {
        capsule.faces.insert(capsule.faces.end(), {{a, b, c}, {b, d, c}});
      } else {
        capsule.faces.insert(capsule.faces.end(), {{a, b, d}, {a, d, c}});
      }
    }
  }
  return capsule;
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
