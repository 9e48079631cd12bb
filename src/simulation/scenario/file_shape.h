#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/choice_text.h"

namespace fissure {

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
  static constexpr ShapeText text{"file",
                                  "a closed surface from an STL, OBJ, PLY or OFF file, in a stated unit",
                                  "a surface from an STL, OBJ, PLY or OFF file, in a stated unit"};

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

  std::optional<double> triangles() const { return std::nullopt; }  ///< only the file says
  std::optional<double> tetrahedra() const { return std::nullopt; }

  bool operator==(const FileShape&) const = default;
};

/// Linear tetrahedra from a mesh file; the surface is their boundary.
struct TetrahedraShape {
  static constexpr ShapeText text{"tetrahedra",
                                  "tetrahedra from a Gmsh (.msh) or VTK (.vtk) file, in a stated unit",
                                  "the boundary of tetrahedra from a .msh or .vtk file, in a stated unit"};

  std::string file;                 ///< relative to the scenario's directory; its ending says the format
  LengthUnit unit = LengthUnit::m;  ///< of the file's numbers; no default, as for surfaces

  std::optional<double> triangles() const { return std::nullopt; }  ///< only the file says
  std::optional<double> tetrahedra() const { return std::nullopt; }

  bool operator==(const TetrahedraShape&) const = default;
};

}  // namespace fissure
