#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// A connected part of a surface, with one of its corners. As long as it crosses no other surface, it lies
/// inside or outside of that as this corner does.
struct SurfacePart {
  int corner = 0;
  std::vector<Face> faces;
};

/// The connected parts of a surface, in the order of their first faces; vertices without faces belong to
/// none.
std::vector<SurfacePart> partsOf(const TriangleMesh& mesh);

/// Whether it is proved that no part of a closed surface encloses a point: the winding number of each single
/// part, the sum of its triangles' solid angles over 4 pi (van Oosterom and Strackee 1983), is 0. Parts that
/// are inside out, or around a cavity, enclose their inside too, so a point in a cavity is not proved
/// outside. False where a triangle is so near that rounding leaves its side undecided. `vertices_m` and
/// `point_m` are in the same frame, metres.
bool isProvedOutside(std::span<const SurfacePart> parts, std::span<const Vec3> vertices_m,
                     const Vec3& point_m);

}  // namespace fissure
