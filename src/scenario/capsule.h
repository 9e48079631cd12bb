#pragma once

#include <cmath>
#include <numbers>

namespace fissure {

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

}  // namespace fissure
