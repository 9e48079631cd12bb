#include "mesh/lobes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "mesh/hexahedron.h"

namespace fissure {
namespace {

/// The lobe at x >= 0: a block of cells whose surface is mapped to a quarter of an ellipsoid. Its faces are
/// left out where it is joined to its mirror image.
class Lobe {
 public:
  explicit Lobe(const LobesShape& shape) : shape_(shape) {
    const LobesShape::Cells cells = shape.cells();
    x_cells_ = static_cast<int>(cells.across);
    joined_cells_ = static_cast<int>(cells.joined);
    y_cells_ = joined_cells_ + static_cast<int>(cells.parted);
    z_cells_ = static_cast<int>(cells.half_along);
    slit_floor_ = 1 - shape.slit_depth_m / shape.size_m.y();
  }

  /// Its faces; vertices on the seam, where it is joined to its mirror image, have x = 0.
  TriangleMesh surface() {
    for (int k = -z_cells_; k < z_cells_; ++k) {
      for (int i = 0; i < x_cells_; ++i) {
        addQuad({i, 0, k}, {1, 0, 0}, {0, 0, 1});         // the flat side
        addQuad({i, y_cells_, k}, {0, 0, 1}, {1, 0, 0});  // the top
      }
      for (int j = 0; j < y_cells_; ++j) {
        addQuad({x_cells_, j, k}, {0, 1, 0}, {0, 0, 1});                   // the outer side
        if (j >= joined_cells_) addQuad({0, j, k}, {0, 0, 1}, {0, 1, 0});  // the wall of the slit
      }
    }
    for (int j = 0; j < y_cells_; ++j) {
      for (int i = 0; i < x_cells_; ++i) {
        addQuad({i, j, z_cells_}, {1, 0, 0}, {0, 1, 0});
        addQuad({i, j, -z_cells_}, {0, 1, 0}, {1, 0, 0});
      }
    }
    return {vertices_m_, std::move(faces_)};
  }

  /// All of it, after surface(), whose vertices come first: cells cut around the diagonals that start and end
  /// where those of addQuad do.
  TetrahedralMesh volume() {
    TetrahedralMesh made;
    for (int k = -z_cells_; k < z_cells_; ++k) {
      for (int j = 0; j < y_cells_; ++j) {
        for (int i = 0; i < x_cells_; ++i) {
          std::array<int, 8> corners{};
          for (int corner = 0; corner < 8; ++corner)
            corners[static_cast<std::size_t>(corner)] =
                vertex({i + (corner & 1), j + ((corner >> 1) & 1), k + ((corner >> 2) & 1)});
          addKuhnTetrahedra(corners, k < 0 ? 4 : 0, made.tetrahedra);
        }
      }
    }
    made.vertices_m = vertices_m_;
    return made;
  }

 private:
  using Cell = std::array<int, 3>;

  /// Two triangles with corners c, c + a, c + a + b, c + b, parted from the corner nearest to the slit's
  /// middle line to the farthest one: the corners of the cube, flat on the ellipsoid, then make no sliver.
  void addQuad(const Cell& c, const Cell& a, const Cell& b) {
    const Cell ca{c[0] + a[0], c[1] + a[1], c[2] + a[2]}, cb{c[0] + b[0], c[1] + b[1], c[2] + b[2]};
    const Cell cab{ca[0] + b[0], ca[1] + b[1], ca[2] + b[2]};
    const int p = vertex(c), q = vertex(ca), r = vertex(cab), s = vertex(cb);
    const bool along_z = a[2] + b[2] != 0;
    if (along_z && c[2] < 0) {
      faces_.insert(faces_.end(), {{p, q, s}, {q, r, s}});
    } else {
      faces_.insert(faces_.end(), {{p, q, r}, {p, r, s}});
    }
  }

  int vertex(const Cell& corner) {
    const auto [found, is_new] = index_.try_emplace(corner, static_cast<int>(vertices_m_.size()));
    if (is_new) vertices_m_.push_back(position_m(corner));
    return found->second;
  }

  /// From the cube to the ball (each axis scaled by the other two, so that the cube's faces become the
  /// sphere), then to the ellipsoid, moved aside by half the slit's width at that height.
  Vec3 position_m(const Cell& corner) const {
    const double x = static_cast<double>(corner[0]) / x_cells_, z = static_cast<double>(corner[2]) / z_cells_;
    const double y =
        corner[1] < joined_cells_  // not its rounded quotient on the floor itself, where both lobes meet
            ? slit_floor_ * corner[1] / joined_cells_
            : slit_floor_ + (1 - slit_floor_) * (corner[1] - joined_cells_) / (y_cells_ - joined_cells_);
    const auto scale = [](double a, double b) {
      return std::sqrt(1 - a * a / 2 - b * b / 2 + a * a * b * b / 3);
    };
    const double half_slit_m = shape_.slit_width_m / 2;
    const double open = std::max(0.0, (y - slit_floor_) / (1 - slit_floor_));
    const double out = outward(corner, {x, y, z});
    return {half_slit_m * open + (shape_.size_m.x() / 2 - half_slit_m * open) * x * scale(out * y, out * z),
            shape_.size_m.y() * y * scale(out * x, out * z),
            shape_.size_m.z() / 2 * z * scale(out * x, out * y)};
  }

  /// What the other two coordinates are multiplied by before they scale an axis: 1 on the surface. The cube's
  /// upper edges and corners are flat on the ball, and so would be the cells along them; inside, the map goes
  /// over to that of the shell of the same largest coordinate, which bends there too. It stays as it is
  /// towards the flat side and the slit, which are shells of no ball.
  double outward(const Cell& corner, const Vec3& at) const {
    if (corner[0] == x_cells_ || corner[1] == y_cells_ || std::abs(corner[2]) == z_cells_) return 1;
    const double largest = at.cwiseAbs().maxCoeff();
    const double share = at.x() * (2 - at.x()) * at.y() * (2 - at.y());
    return share > 0 ? std::sqrt(1 + share * (1 / (largest * largest) - 1)) : 1;
  }

  LobesShape shape_;
  int x_cells_ = 0, y_cells_ = 0, z_cells_ = 0, joined_cells_ = 0;
  double slit_floor_ = 0;  ///< height of the slit's floor over the whole height
  std::vector<Vec3> vertices_m_;
  std::vector<Face> faces_;
  std::map<Cell, int> index_;
};

/// Both lobes' vertices, and which of them each of a lobe's and its mirror image are: the same on the seam.
struct BothSides {
  std::vector<Vec3> vertices_m;
  std::vector<int> own, mirrored;

  /// Appends vertices of the lobe, all of them before all of their images.
  void add(const std::vector<Vec3>& lobe_m, std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      own.push_back(static_cast<int>(vertices_m.size()));
      vertices_m.push_back(lobe_m[v]);
    }
    for (std::size_t v = first; v < last; ++v) {
      const Vec3& at = lobe_m[v];
      mirrored.push_back(at.x() == 0 ? own[v] : static_cast<int>(vertices_m.size()));
      if (at.x() != 0) vertices_m.emplace_back(-at.x(), at.y(), at.z());
    }
  }
};

}  // namespace

TriangleMesh makeLobes(const LobesShape& shape) {
  assert(shape.size_m.minCoeff() > 0 && shape.edge_m > 0);
  assert(shape.slit_depth_m > 0 && shape.slit_depth_m < shape.size_m.y());
  const TriangleMesh lobe = Lobe(shape).surface();
  BothSides both;
  both.add(lobe.vertices_m, 0, lobe.vertices_m.size());
  TriangleMesh mesh{std::move(both.vertices_m), lobe.faces};
  for (const auto& [a, b, c] : lobe.faces)
    mesh.faces.push_back({both.mirrored[a], both.mirrored[c], both.mirrored[b]});
  return mesh;
}

TetrahedralMesh makeLobesTetrahedra(const LobesShape& shape) {
  Lobe half(shape);
  const std::size_t on_surface = half.surface().vertices_m.size();
  const TetrahedralMesh lobe = half.volume();
  BothSides both;
  both.add(lobe.vertices_m, 0, on_surface);
  both.add(lobe.vertices_m, on_surface, lobe.vertices_m.size());
  TetrahedralMesh mesh{std::move(both.vertices_m), {}};
  mesh.tetrahedra.reserve(2 * lobe.tetrahedra.size());
  for (const auto& [a, b, c, d] : lobe.tetrahedra)
    mesh.tetrahedra.push_back({both.own[a], both.own[b], both.own[c], both.own[d]});
  for (const auto& [a, b, c, d] : lobe.tetrahedra)
    mesh.tetrahedra.push_back({both.mirrored[a], both.mirrored[c], both.mirrored[b], both.mirrored[d]});
  return mesh;
}

}  // namespace fissure
