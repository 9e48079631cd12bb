#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/geometry.h"

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

/// A repair of a mesh from a file, in the order in which repairs are done.
enum class MeshRepair {
  drop_degenerate,       ///< triangles without area
  drop_duplicate_faces,  ///< all but one of the triangles with the same three corners
  keep_largest_shell,    ///< of pieces that share no vertex, the one of the largest area stays
  drop_unreferenced,     ///< vertices that are part of no triangle
  orient,                ///< neighbours made to agree; closed shells turned outward, cavities inward
  cap_holes,             ///< each boundary loop closed by a fan around its middle
};

/// A triangle surface from a file: STL, OBJ, PLY or OFF.
struct FileShape {
  std::string file;  ///< relative to the scenario's directory; its ending says the format
  /// Of the file's numbers. No format states it, and a wrong one is off by a thousand: no default.
  LengthUnit unit = LengthUnit::m;
  /// Vertices no farther apart become one, >= 0; 0: only equal ones, which STL writes for each triangle anew.
  double weld_tolerance_m = 0.0;
  /// Each once. They are done in the order of MeshRepair, and only those; what they changed is in the
  /// result's summary.
  std::vector<MeshRepair> repairs;
  /// Triangles are split until no edge is longer, > 0; default: as in the file.
  std::optional<double> max_edge_m;

  bool operator==(const FileShape&) const = default;
};

/// A cylinder with round ends along x around its own origin: an elongated vessel. The ends are halves of a
/// sphere of as many `subdivisions`; between them triangles about as long as theirs.
struct CapsuleShape {
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

  bool operator==(const CapsuleShape&) const = default;
};

/// Two lobes of a half ellipsoid on its flat side, parted by a slit along z and joined below it: a fissure.
/// The origin is the middle of the flat side, y up. The same on both sides of x = 0, to the last bit.
struct LobesShape {
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

  bool operator==(const LobesShape&) const = default;
};

/// What a body or a tool can look like.
using SurfaceShape = std::variant<SphereShape, BoxShape, TrianglesShape, FileShape, CapsuleShape, LobesShape>;

}  // namespace fissure
