#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "base/geometry.h"
#include "scenario/choice_text.h"
#include "scenario/file_shape.h"
#include "scenario/lobes_shape.h"
#include "scenario/round_shapes.h"

namespace fissure {

/// The largest number of triangles of a body or a tool: that of a sphere with 7 subdivisions.
inline constexpr std::size_t most_triangles = 131072;

/// The largest number of tetrahedra of an elastic body: that of a sphere with 6 subdivisions.
inline constexpr double most_tetrahedra = 2097152;

/// A box centred on its own origin, with full edge lengths and two triangles per cell of a face.
struct BoxShape {
  static constexpr ShapeText text{"box", "full edge lengths; 12 triangles, or two for each of its `cells`",
                                  "full edge lengths"};

  Vec3 size_m = {0.04, 0.002, 0.015};
  std::array<int, 3> cells = {1, 1, 1};

  double triangles() const {
    const double x = cells[0], y = cells[1], z = cells[2];
    return 4 * (x * y + y * z + z * x);
  }
  double tetrahedra() const { return 6.0 * cells[0] * cells[1] * cells[2]; }

  bool operator==(const BoxShape&) const = default;
};

/// A surface from plain arrays, closed and with outward faces.
struct TrianglesShape {
  static constexpr ShapeText text{"triangles", "a closed surface from plain arrays",
                                  "a surface from plain arrays"};

  std::vector<Vec3> vertices_m;
  std::vector<Face> faces;

  double triangles() const { return static_cast<double>(faces.size()); }
  static std::optional<double> tetrahedra() { return {}; }  ///< known only from the mesher

  bool operator==(const TrianglesShape&) const = default;
};

template <class Io>
void describe(Io& io, BoxShape& s) {
  io.field("size_m", s.size_m,
           Key("Full edge lengths of the box along its own x, y and z; its origin is its middle.")
               .above(0)
               .required());
  io.field("cells", s.cells,
           Key("Cells of each face along x, y and z, two triangles each. Where all are even the mesh is its "
               "own mirror image.")
               .count(1, 128));
}

template <class Io>
void describe(Io& io, TrianglesShape& s) {
  io.field("vertices_m", s.vertices_m,
           Key("Vertices of the surface, in the shape's own frame.").items(4, any_number).required());
  io.field("faces", s.faces,
           Key("Triangles: three vertex indices from 0 each, counter-clockwise seen from outside.")
               .noUnit()
               .items(4, most_triangles)
               .required());
}

/// The shape of a body or a tool, in the catalog's order.
using SurfaceShape =
    std::variant<SphereShape, BoxShape, TrianglesShape, FileShape, CapsuleShape, LobesShape, TetrahedraShape>;

/// Number of triangles of a shape's surface; no value where only a file has it.
inline std::optional<double> trianglesOf(const SurfaceShape& shape) {
  return std::visit([](const auto& one) { return std::optional<double>(one.triangles()); }, shape);
}

/// Number of tetrahedra of a shape's volume; no value where only a file or the mesher determines it.
inline std::optional<double> tetrahedraOf(const SurfaceShape& shape) {
  return std::visit([](const auto& one) { return std::optional<double>(one.tetrahedra()); }, shape);
}

}  // namespace fissure
