#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/geometry.h"
#include "scenario/capsule.h"
#include "scenario/lobes_shape.h"

namespace fissure {

/// An octahedron, each triangle split in four `subdivisions` times and projected on the sphere: 8 x 4^n
/// triangles.
struct SphereShape {
  double radius_m = 0.03;
  int subdivisions = 2;  ///< 0..7; 2: 128 triangles (the paper's), 3: 512, 4: 2048

  bool operator==(const SphereShape&) const = default;
};

/// A box centred on its own origin, full edge lengths.
struct BoxShape {
  Vec3 size_m = {0.04, 0.002, 0.015};

  bool operator==(const BoxShape&) const = default;
};

/// Plain arrays: a closed, consistently outward-oriented surface.
struct TrianglesShape {
  std::vector<Vec3> vertices_m;
  std::vector<Face> faces;  ///< vertex indices from 0, counter-clockwise seen from outside

  bool operator==(const TrianglesShape&) const = default;
};

enum class LengthUnit { m, mm, cm };

/// How many metres one `unit` is.
constexpr double metres(LengthUnit unit) {
  return unit == LengthUnit::m ? 1.0 : unit == LengthUnit::cm ? 1e-2 : 1e-3;
}

/// A triangle surface from a file: STL, OBJ, PLY or OFF.
struct FileShape {
  std::string file;  ///< relative to the scenario's directory; its ending says the format
  /// Of the file's numbers. No format states it, and a wrong one is off by a thousand: no default.
  LengthUnit unit = LengthUnit::m;
  /// Vertices no farther apart become one, >= 0; 0: only equal ones, which STL writes for each triangle anew.
  double weld_tolerance_m = 0.0;
  /// Names in catalog().mesh_repairs. They are done in the catalog's order, and only those; what they changed
  /// is in the result's summary.
  std::vector<std::string> repairs;
  /// Triangles are split until no edge is longer, > 0; default: as in the file.
  std::optional<double> max_edge_m;

  bool operator==(const FileShape&) const = default;
};

/// What a body or a tool can look like.
using SurfaceShape = std::variant<SphereShape, BoxShape, TrianglesShape, FileShape, CapsuleShape, LobesShape>;

}  // namespace fissure
