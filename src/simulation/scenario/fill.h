#pragma once

#include <optional>

#include "scenario/key.h"

namespace fissure {

/// How the mesher (TetGen) fills a closed surface with tetrahedra.
struct FillSettings {
  bool keep_surface = true;
  double radius_edge_ratio = 1.4;
  double least_dihedral_deg = 15;
  std::optional<double> max_edge_m;

  bool operator==(const FillSettings&) const = default;
};

template <class Io>
void describe(Io& io, FillSettings& f) {
  io.field("keep_surface", f.keep_surface,
           Key("Whether the triangles of the surface stay as they are, with every new vertex inside; else "
               "the mesher may cut them where that makes better tetrahedra, and the body's surface is what "
               "it made of them."));
  io.field("radius_edge_ratio", f.radius_edge_ratio,
           Key("Largest radius of a tetrahedron's circumscribed sphere over its shortest edge. Smaller "
               "values make more and rounder tetrahedra; slivers can have good values, `least_dihedral_deg` "
               "is against them.")
               .noUnit()
               .between(1.1, 10));
  io.field(
      "least_dihedral_deg", f.least_dihedral_deg,
      Key("Smallest angle between two sides of a tetrahedron, where the surface allows it.").between(0, 20));
  io.field(
      "max_edge_m", f.max_edge_m,
      Key("No tetrahedron is larger than a regular one of this edge. Where the surface is kept, tetrahedra "
          "next to large triangles may be larger: split those first (`max_edge_m` of the shape).")
          .above(0)
          .otherwise("as the surface makes them"));
}

}  // namespace fissure
