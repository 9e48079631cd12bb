#pragma once

#include <array>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Octahedron around the origin, each triangle split in four `subdivisions` times; new vertices are projected
/// on the sphere after every split, so that an edge on a great circle is always halved evenly. 8 x 4^n
/// outward triangles, 4^(n+1) + 2 vertices, all at `radius_m` (metres).
TriangleMesh makeSphere(double radius_m, int subdivisions);

/// A cylinder along x around the origin with the halves of makeSphere at its ends, outward triangles.
/// length_m: of the cylinder; `rows` of triangles along it, with diagonals that alternate: a mesh without a
/// handedness, its own mirror image in x = 0 (for an even number of rows), y = 0 and z = 0.
TriangleMesh makeCapsule(double radius_m, double length_m, int subdivisions, int rows);

/// The surface of makeCapsule with its rings of vertices around the cylinder, from x = -length_m / 2 to
/// length_m / 2, each in the order of the turn about x.
struct CapsuleSurface {
  TriangleMesh mesh;
  std::vector<std::vector<int>> rings;
};
CapsuleSurface makeCapsuleSurface(double radius_m, double length_m, int subdivisions, int rows);

/// Box centred on the origin, full edge lengths in metres, cut into `cells` along x, y and z, each > 0: two
/// outward triangles a cell of each face, with diagonals that mirror each other across every plane between
/// cells. With one cell along each axis 8 vertices, 12 triangles. Where the number of cells along an axis is
/// even the mesh is its own mirror image along it.
TriangleMesh makeBox(const Vec3& size_m, const std::array<int, 3>& cells = {1, 1, 1});

}  // namespace fissure
