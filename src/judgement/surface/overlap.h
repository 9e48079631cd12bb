#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// A connected part of a surface. As long as it crosses nothing, what part of space it lies in is that of any
/// of its corners.
struct SurfacePart {
  int corner = 0;
  std::vector<Face> faces;
};

/// The parts of a surface, in the order of their first faces; vertices that no face has are in none.
std::vector<SurfacePart> partsOf(const TriangleMesh& mesh);

/// Whether no part of a closed surface encloses a point: proved where the winding number of each by itself,
/// the sum of its triangles' solid angles over 4 pi (van Oosterom and Strackee 1983), is 0. A part that is
/// inside out encloses what it holds as well, and so does one around a cavity: who is in a cavity is not
/// proved outside. False where a triangle is so near that rounding leaves its side open. `vertices_m` and
/// `point_m` in one frame, metres.
bool isProvedOutside(std::span<const SurfacePart> parts, std::span<const Vec3> vertices_m,
                     const Vec3& point_m);

}  // namespace fissure
