#include "mesh/primitives.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "base/reproducible.h"
#include "mesh/box_grid.h"
#include "mesh/split_faces.h"

namespace fissure {
namespace {

/// Moves the halves of a sphere length_m apart along x, its ring in x = 0 with the left one. The ring, in the
/// order of the turn about x.
std::vector<int> drawApart(TriangleMesh& sphere, double length_m) {
  std::vector<int> ring;
  for (int v = 0; v < static_cast<int>(sphere.vertices_m.size()); ++v) {
    double& x_m = sphere.vertices_m[v].x();
    if (x_m == 0) ring.push_back(v);
    x_m += x_m > 0 ? length_m / 2 : -length_m / 2;
  }
  const auto angle = [&](int v) {
    return reproducible::atan2(sphere.vertices_m[v].z(), sphere.vertices_m[v].y());
  };
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

/// Two triangles, parted from the first corner to the third or, `other_way`, from the second to the fourth.
void addQuad(const std::array<int, 4>& corners, bool other_way, std::vector<Face>& faces) {
  const auto [p, q, r, s] = corners;
  if (other_way) {
    faces.insert(faces.end(), {{p, q, s}, {q, r, s}});
  } else {
    faces.insert(faces.end(), {{p, q, r}, {p, r, s}});
  }
}

}  // namespace

TriangleMesh makeSphere(double radius_m, int subdivisions) {
  assert(radius_m > 0 && subdivisions >= 0);
  const double r = radius_m;
  TriangleMesh sphere;
  sphere.vertices_m = {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  sphere.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const auto middle = [&](const Vec3& a, const Vec3& b) { return Vec3(r * Vec3(a + b).normalized()); };
  for (int level = 0; level < subdivisions; ++level) splitFaces(sphere.vertices_m, sphere.faces, middle);
  return sphere;
}

CapsuleSurface makeCapsuleSurface(double radius_m, double length_m, int subdivisions, int rows) {
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
  return {std::move(capsule), std::move(rings)};
}

TriangleMesh makeCapsule(double radius_m, double length_m, int subdivisions, int rows) {
  return makeCapsuleSurface(radius_m, length_m, subdivisions, rows).mesh;
}

TriangleMesh makeBox(const Vec3& size_m, const std::array<int, 3>& cells) {
  assert(size_m.minCoeff() > 0);
  const BoxGrid grid(cells);
  TriangleMesh box;
  for (const GridPoint& point : grid.surface()) box.vertices_m.push_back(grid.position_m(point, size_m));
  struct Side {
    std::size_t across, first, second;  ///< axes; the outward normal's, and those of a quad's first two edges
    bool high;
  };
  for (const auto& [across, first, second, high] :
       {Side{0, 2, 1, false}, Side{0, 1, 2, true}, Side{1, 0, 2, false}, Side{1, 2, 0, true},
        Side{2, 1, 0, false}, Side{2, 0, 1, true}}) {
    GridPoint cell{};
    cell[across] = high ? cells[across] : 0;
    for (cell[second] = 0; cell[second] < cells[second]; ++cell[second]) {
      for (cell[first] = 0; cell[first] < cells[first]; ++cell[first]) {
        GridPoint second_corner = cell, third_corner = cell, fourth_corner = cell;
        ++second_corner[first], ++third_corner[first], ++third_corner[second], ++fourth_corner[second];
        addQuad({grid.index(cell), grid.index(second_corner), grid.index(third_corner),
                 grid.index(fourth_corner)},
                (cell[first] + cell[second]) % 2 != 0, box.faces);
      }
    }
  }
  return box;
}

}  // namespace fissure
