#pragma once

#include "base/geometry.h"

namespace fissure {

/// Octahedron around the origin, each triangle split in four `subdivisions` times; new vertices are projected
/// on the sphere after every split, so that an edge on a great circle is always halved evenly. 8 x 4^n
/// outward triangles, 4^(n+1) + 2 vertices, all at `radius_m` (metres).
TriangleMesh makeSphere(double radius_m, int subdivisions);

/// Box centred on the origin, full edge lengths in metres: 8 vertices, 12 outward triangles.
TriangleMesh makeBox(const Vec3& size_m);

}  // namespace fissure
