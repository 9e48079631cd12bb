#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/catalog.h"
#include "scenario/choice_text.h"
#include "scenario/key.h"

namespace fissure {

enum class LengthUnit { m, mm, cm };

/// The length of one `unit` in metres.
constexpr double metres(LengthUnit unit) {
  return unit == LengthUnit::m ? 1.0 : unit == LengthUnit::cm ? 1e-2 : 1e-3;
}

/// A repair of a mesh from a file, in the order in which repairs are applied.
enum class MeshRepair {
  drop_degenerate,       ///< removes triangles without area
  drop_duplicate_faces,  ///< removes all but one of the triangles with the same three corners
  keep_largest_shell,    ///< keeps only the connected piece with the largest area
  drop_unreferenced,     ///< removes vertices that are part of no triangle
  orient,     ///< gives neighbours the same orientation; turns closed shells outward, cavities inward
  cap_holes,  ///< closes each boundary loop by a fan of triangles around its middle
};

/// A triangle surface from a file: STL, OBJ, PLY or OFF.
struct FileShape {
  static constexpr ShapeText text{"file",
                                  "a closed surface from an STL, OBJ, PLY or OFF file, in a stated unit",
                                  "a surface from an STL, OBJ, PLY or OFF file, in a stated unit"};

  std::string file;
  LengthUnit unit = LengthUnit::m;
  double weld_tolerance_m = 0.0;
  std::vector<MeshRepair> repairs;
  std::optional<double> max_edge_m;

  std::optional<double> triangles() const { return std::nullopt; }  ///< known only from the file
  std::optional<double> tetrahedra() const { return std::nullopt; }

  bool operator==(const FileShape&) const = default;
};

/// Linear tetrahedra from a mesh file; the surface is their boundary.
struct TetrahedraShape {
  static constexpr ShapeText text{"tetrahedra",
                                  "tetrahedra from a Gmsh (.msh) or VTK (.vtk) file, in a stated unit",
                                  "the boundary of tetrahedra from a .msh or .vtk file, in a stated unit"};

  std::string file;
  LengthUnit unit = LengthUnit::m;

  std::optional<double> triangles() const { return std::nullopt; }  ///< known only from the file
  std::optional<double> tetrahedra() const { return std::nullopt; }

  bool operator==(const TetrahedraShape&) const = default;
};

template <class Io>
void describe(Io& io, FileShape& s) {
  io.field("file", s.file,
           Key("Mesh file, STL, OBJ, PLY or OFF by its ending, relative to the folder of the scenario file.")
               .required());
  io.field("unit", s.unit,
           Key("Unit of the file's numbers. No format states it, and a wrong one is off by a thousand.")
               .oneOf(catalog().length_units)
               .required());
  io.field("weld_tolerance_m", s.weld_tolerance_m,
           Key("Vertices that are no farther apart become one; 0 joins only equal ones, which STL writes for "
               "each triangle anew.")
               .atLeast(0));
  io.field("repairs", s.repairs,
           Key("What is repaired of the mesh, each once and in the order of this list; the result's summary "
               "says what it changed.")
               .oneOf(catalog().mesh_repairs));
  io.field(
      "max_edge_m", s.max_edge_m,
      Key("Triangles are split until no edge is longer.").above(0).otherwise("triangles as in the file"));
}

template <class Io>
void describe(Io& io, TetrahedraShape& s) {
  io.field("file", s.file,
           Key("Mesh file of linear tetrahedra, Gmsh (.msh) or VTK (.vtk) by its ending, relative to the "
               "folder of the scenario file.")
               .required());
  io.field("unit", s.unit,
           Key("Unit of the file's numbers. No format states it, and a wrong one is off by a thousand.")
               .oneOf(catalog().length_units)
               .required());
}

}  // namespace fissure
