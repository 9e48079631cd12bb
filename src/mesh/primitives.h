#pragma once

#include "base/geometry.h"

namespace fissure {

/// Octahedron, each triangle split in four `subdivisions` times, vertices projected on the sphere around the origin:
/// 8 x 4^n triangles, 4^(n+1) + 2 vertices, outward faces. radius in metres.
TriangleMesh makeSphere(double radius_m, int subdivisions);

/// Box centred on the origin, full edge lengths in metres: 8 vertices, 12 outward triangles.
TriangleMesh makeBox(const Vec3& size_m);

}  // namespace fissure
