#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "base/geometry.h"
#include "scenario/choice_text.h"
#include "scenario/file_shape.h"

namespace fissure {

/// The most triangles of a body or a tool: of a sphere with 7 subdivisions.
inline constexpr std::size_t most_triangles = 131072;

/// The most tetrahedra of an elastic body: of a sphere with 6 subdivisions.
inline constexpr double most_tetrahedra = 2097152;

/// An octahedron, each triangle split in four `subdivisions` times and projected on the sphere: 8 x 4^n
/// triangles.
struct SphereShape {
  static constexpr ShapeText text{"sphere", "subdivided octahedron, 8 x 4^subdivisions triangles",
                                  "subdivided octahedron, as a body's"};

  double radius_m = 0.03;
  int subdivisions = 2;  ///< 0..7; 2: 128 triangles (the paper's), 3: 512, 4: 2048

  double triangles() const { return 8 * std::pow(4, subdivisions); }
  double tetrahedra() const { return 8 * std::pow(8, subdivisions); }

  bool operator==(const SphereShape&) const = default;
};

/// A box centred on its own origin, full edge lengths, with two triangles for each cell of a face.
struct BoxShape {
  static constexpr ShapeText text{"box", "full edge lengths; 12 triangles, or two for each of its `cells`",
                                  "full edge lengths"};

  Vec3 size_m = {0.04, 0.002, 0.015};
  /// Along x, y and z, 1..128 each. Where all are even the mesh is its own mirror image.
  std::array<int, 3> cells = {1, 1, 1};

  double triangles() const {
    const double x = cells[0], y = cells[1], z = cells[2];
    return 4 * (x * y + y * z + z * x);
  }
  double tetrahedra() const { return 6.0 * cells[0] * cells[1] * cells[2]; }

  bool operator==(const BoxShape&) const = default;
};

/// Plain arrays: a closed, consistently outward-oriented surface.
struct TrianglesShape {
  static constexpr ShapeText text{"triangles", "a closed surface from plain arrays",
                                  "a surface from plain arrays"};

  std::vector<Vec3> vertices_m;
  std::vector<Face> faces;  ///< vertex indices from 0, counter-clockwise seen from outside

  double triangles() const { return static_cast<double>(faces.size()); }
  static std::optional<double> tetrahedra() { return {}; }  ///< only the mesher says

  bool operator==(const TrianglesShape&) const = default;
};

/// A cylinder with round ends along x around its own origin: an elongated vessel. The ends are halves of a
/// sphere of as many `subdivisions`; between them triangles about as long as theirs.
struct CapsuleShape {
  static constexpr ShapeText text{"capsule",
                                  "a cylinder with round ends along x; 4 x 2^subdivisions vertices around",
                                  "a cylinder with round ends along x, as a body's"};

  double radius_m = 0.008;
  double length_m = 0.06;  ///< of the cylinder, without its round ends
  int subdivisions = 2;    ///< 0..7; 4 x 2^n vertices around

  int around() const { return 4 << subdivisions; }
  /// Rows of triangles along the cylinder; even, so that the mesh is the same on both sides of its middle.
  double rows() const {
    const double edge_m = 2 * std::numbers::pi * radius_m / around();
    return 2 * std::fmax(1, std::round(length_m / (2 * edge_m)));
  }
  double triangles() const { return 8 * std::pow(4, subdivisions) + 2.0 * around() * rows(); }
  double tetrahedra() const {
    return 8 * std::pow(8, subdivisions) + 12 * rows() * std::pow(4, subdivisions);
  }

  bool operator==(const CapsuleShape&) const = default;
};

/// Two lobes of a half ellipsoid on its flat side, parted by a slit along z and joined below it: a fissure.
/// The origin is the middle of the flat side, y up. The same on both sides of x = 0, to the last bit.
struct LobesShape {
  static constexpr ShapeText text{"lobes", "half an ellipsoid parted by a slit, mirror-symmetric: a fissure",
                                  "as a body's"};

  Vec3 size_m = {0.08, 0.04, 0.08};  ///< of the whole, > 0: across the slit, in height, along the slit
  double slit_depth_m = 0.028;       ///< from the top, in the middle, > 0, below the height
  double slit_width_m = 0.001;  ///< at the top, > 0, below half the size across; closes towards its floor
  /// Longest edge of the cells, two triangles each, of the upright block whose surface is bent into the
  /// ellipsoid, > 0.
  double edge_m = 0.006;

  struct Cells {
    double across = 0;      ///< in one lobe
    double joined = 0;      ///< in height, below the slit's floor
    double parted = 0;      ///< in height, above it
    double half_along = 0;  ///< on each side of z = 0
  };
  Cells cells() const {
    const auto along = [this](double length_m) { return std::max(1.0, std::ceil(length_m / edge_m - 1e-9)); };
    return {along(size_m.x() / 2), along(size_m.y() - slit_depth_m), along(slit_depth_m),
            along(size_m.z() / 2)};
  }
  double triangles() const {
    const Cells n = cells();
    const double height = n.joined + n.parted;
    return 8 * (n.half_along * (2 * n.across + height + n.parted) + height * n.across);
  }
  double tetrahedra() const {
    const Cells n = cells();
    return 24 * n.across * (n.joined + n.parted) * n.half_along;
  }

  bool operator==(const LobesShape&) const = default;
};

/// What a body or a tool can look like, in the catalog's order.
using SurfaceShape =
    std::variant<SphereShape, BoxShape, TrianglesShape, FileShape, CapsuleShape, LobesShape, TetrahedraShape>;

/// How many triangles the surface of a shape has; nothing where only a file says.
inline std::optional<double> trianglesOf(const SurfaceShape& shape) {
  return std::visit([](const auto& one) { return std::optional<double>(one.triangles()); }, shape);
}

/// How many tetrahedra its volume has; nothing where only a file or the mesher says.
inline std::optional<double> tetrahedraOf(const SurfaceShape& shape) {
  return std::visit([](const auto& one) { return std::optional<double>(one.tetrahedra()); }, shape);
}

}  // namespace fissure
