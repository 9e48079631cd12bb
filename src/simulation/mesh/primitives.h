#pragma once

#include <array>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// A sphere: an octahedron around the origin whose triangles are split in four n = `subdivisions` times. New
/// vertices are projected on the sphere after every split, so that an edge on a great circle is always halved
/// evenly. 8 x 4^n outward triangles, 4^(n+1) + 2 vertices, all at `radius_m` from the origin.
TriangleMesh makeSphere(double radius_m, int subdivisions);

/// A cylinder of length `length_m` along x, centred on the origin, with the halves of makeSphere at its ends;
/// outward triangles. Along the cylinder there are `rows` rows of triangles with alternating diagonals, so
/// that the mesh is mirror-symmetric in y = 0 and z = 0, and for an even number of rows in x = 0.
TriangleMesh makeCapsule(double radius_m, double length_m, int subdivisions, int rows);

/// The surface of makeCapsule with the rings of vertices around its cylinder, from x = -length_m / 2 to
/// length_m / 2, each in the sense of rotation about x.
struct CapsuleSurface {
  TriangleMesh mesh;
  std::vector<std::vector<int>> rings;
};
CapsuleSurface makeCapsuleSurface(double radius_m, double length_m, int subdivisions, int rows);

/// A box centred on the origin with full edge lengths in metres, cut into `cells` along x, y and z, each > 0.
/// Each cell of a face has two outward triangles, whose diagonals are mirrored across every plane between
/// cells. One cell along each axis gives 8 vertices and 12 triangles. The mesh is mirror-symmetric along each
/// axis with an even number of cells.
TriangleMesh makeBox(const Vec3& size_m, const std::array<int, 3>& cells = {1, 1, 1});

}  // namespace fissure
