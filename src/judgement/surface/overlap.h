#pragma once

#include <span>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// One corner of each connected part of a surface: what part of space a part lies in is that of any of its
/// points, as long as it crosses nothing.
std::vector<int> cornersOfParts(const TriangleMesh& mesh);

/// Whether a closed surface is proved not to enclose a point: its winding number there, the sum of all
/// triangles' solid angles over 4 pi (van Oosterom and Strackee 1983), is 0. False as well where a triangle
/// is so near that rounding leaves its side open. An inside-out part encloses what it holds, too.
/// `vertices_m` and `point_m` in one frame, metres.
bool isProvedOutside(std::span<const Face> faces, std::span<const Vec3> vertices_m, const Vec3& point_m);

}  // namespace fissure
