#pragma once

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

/// Box centred on the origin, full edge lengths in metres: 8 vertices, 12 outward triangles.
TriangleMesh makeBox(const Vec3& size_m);

}  // namespace fissure
