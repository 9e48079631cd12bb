#include "mesh/lobes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

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
    return std::move(mesh_);
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
      mesh_.faces.insert(mesh_.faces.end(), {{p, q, s}, {q, r, s}});
    } else {
      mesh_.faces.insert(mesh_.faces.end(), {{p, q, r}, {p, r, s}});
    }
  }

  int vertex(const Cell& corner) {
    const auto [found, is_new] = index_.try_emplace(corner, static_cast<int>(mesh_.vertices_m.size()));
    if (is_new) mesh_.vertices_m.push_back(position_m(corner));
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
    return {half_slit_m * open + (shape_.size_m.x() / 2 - half_slit_m * open) * x * scale(y, z),
            shape_.size_m.y() * y * scale(x, z), shape_.size_m.z() / 2 * z * scale(x, y)};
  }

  LobesShape shape_;
  int x_cells_ = 0, y_cells_ = 0, z_cells_ = 0, joined_cells_ = 0;
  double slit_floor_ = 0;  ///< height of the slit's floor over the whole height
  TriangleMesh mesh_;
  std::map<Cell, int> index_;
};

}  // namespace

TriangleMesh makeLobes(const LobesShape& shape) {
  assert(shape.size_m.minCoeff() > 0 && shape.edge_m > 0);
  assert(shape.slit_depth_m > 0 && shape.slit_depth_m < shape.size_m.y());
  TriangleMesh mesh = Lobe(shape).surface();
  const std::size_t vertices = mesh.vertices_m.size(), faces = mesh.faces.size();
  std::vector<int> mirrored(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vec3 at = mesh.vertices_m[v];
    mirrored[v] = static_cast<int>(at.x() == 0 ? v : mesh.vertices_m.size());
    if (at.x() != 0) mesh.vertices_m.emplace_back(-at.x(), at.y(), at.z());
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const auto [a, b, c] = mesh.faces[f];
    mesh.faces.push_back({mirrored[a], mirrored[c], mirrored[b]});
  }
  return mesh;
}

}  // namespace fissure
