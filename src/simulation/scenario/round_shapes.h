#pragma once

#include <cmath>
#include <numbers>

#include "scenario/choice_text.h"
#include "scenario/key.h"

namespace fissure {

/// A sphere: an octahedron whose triangles are split in four n = `subdivisions` times and projected on the
/// sphere, 8 x 4^n triangles.
struct SphereShape {
  static constexpr ShapeText text{"sphere", "subdivided octahedron, 8 x 4^subdivisions triangles",
                                  "subdivided octahedron, as a body's"};

  double radius_m = 0.03;
  int subdivisions = 2;

  double triangles() const { return std::ldexp(8, 2 * subdivisions); }
  double tetrahedra() const { return std::ldexp(8, 3 * subdivisions); }

  bool operator==(const SphereShape&) const = default;
};

/// A cylinder along x with round ends, centred on its own origin. The ends are halves of a SphereShape with
/// the same `subdivisions`; the triangles between them are about as long as theirs. `length_m` is the length
/// of the cylinder alone.
struct CapsuleShape {
  static constexpr ShapeText text{"capsule",
                                  "a cylinder with round ends along x; 4 x 2^subdivisions vertices around",
                                  "a cylinder with round ends along x, as a body's"};

  double radius_m = 0.008;
  double length_m = 0.06;
  int subdivisions = 2;

  /// Number of vertices around the cylinder.
  int around() const { return 4 << subdivisions; }
  /// Number of rows of triangles along the cylinder; even, so that the mesh is mirror-symmetric in its
  /// middle.
  double rows() const {
    const double edge_m = 2 * std::numbers::pi * radius_m / around();
    return 2 * std::fmax(1, std::round(length_m / (2 * edge_m)));
  }
  double triangles() const { return std::ldexp(8, 2 * subdivisions) + 2.0 * around() * rows(); }
  double tetrahedra() const {
    return std::ldexp(8, 3 * subdivisions) + std::ldexp(12 * rows(), 2 * subdivisions);
  }

  bool operator==(const CapsuleShape&) const = default;
};

template <class Io>
void describe(Io& io, SphereShape& s) {
  io.field("radius_m", s.radius_m,
           Key("Radius of the sphere, on which all vertices lie.").above(0).required());
  io.field("subdivisions", s.subdivisions,
           Key("How often the eight triangles of an octahedron are split in four: 8 x 4^n triangles, 2 makes "
               "128 (the paper's), 3 makes 512, 4 makes 2048.")
               .count(0, 7));
}

template <class Io>
void describe(Io& io, CapsuleShape& s) {
  io.field("radius_m", s.radius_m, Key("Radius of the cylinder and of its round ends.").above(0).required());
  io.field("length_m", s.length_m,
           Key("Length of the cylinder along x, without its round ends.").above(0).required());
  io.field("subdivisions", s.subdivisions,
           Key("Fineness of the surface: 4 x 2^n vertices around the cylinder.").count(0, 7));
}

}  // namespace fissure
