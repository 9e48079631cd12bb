#pragma once

#include <optional>
#include <span>

#include "base/geometry.h"

namespace fissure::test {

/// Penetration by its definition (measure/METHOD.md 1), with no tree and none of the formulas of the
/// measuring code.

/// Winding number of a closed surface: each triangle's solid angle as the excess of the three dihedral angles
/// over pi (Girard), summed over 4 pi.
double girardWinding(const TriangleMesh& mesh, const Vec3& point_m);

/// Distance to the nearest triangle, each turned into a plane of its own first: inside its outline the
/// height, else height and distance to the outline by Pythagoras (Jones, 3D distance from a point to a
/// triangle, 1995).
double planarDistance_m(const TriangleMesh& mesh, const Vec3& point_m);

/// Distance to the surface of a box centred on the origin, negative inside: to the nearest of its six sides,
/// on which the point is projected and clamped.
double sidesDistance_m(const Vec3& size_m, const Vec3& point_m);

struct SlowPenetration {
  double depth_m = 0;
  double gap_m = 0;     ///< between samples and surface, vertices and tool; of no meaning with depth
  int odd_samples = 0;  ///< where the tissue's winding number is neither 0 nor 1
};

/// Of one box tool, by its surface points `samples_m` (tool's frame), and one body; adds to `result` what is
/// worse. `result.gap_m` must start at infinity.
void measureSlowly(const TriangleMesh& body, const Vec3& tool_size_m, const Pose& tool,
                   std::span<const Vec3> samples_m, SlowPenetration& result);

}  // namespace fissure::test
