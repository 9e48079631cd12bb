#pragma once

#include "base/geometry.h"
#include "surface/surface_tree.h"

namespace fissure {

/// Pose of a tool in the frame of the surface trees, metres.
struct ToolPlacement {
  Mat3 rotation = Mat3::Identity();
  Vec3 origin_m = Vec3::Zero();

  /// The position, in the trees' frame, of a point that is given in the tool's frame.
  Vec3 of(const Vec3& point) const { return rotation * point + origin_m; }
};

/// Largest displacement of any vertex of the surface in its last update, metres.
double longestWay_m(const SurfaceTree& surface);

/// Upper bound of the displacement of all points in a box (tool frame) between two placements, metres.
double longestWay_m(const TreeBox& extent, const ToolPlacement& before, const ToolPlacement& now);

/// Whether a tool has turned by at most 90 degrees.
bool turnIsAcute(const ToolPlacement& before, const ToolPlacement& now);

/// Largest displacement, seen from the tool, in the last update, of surface that was within `reach_m` of the
/// box `extent` (tool frame) before it, metres.
double nearWay_m(const TreeBox& extent, const ToolPlacement& before, const ToolPlacement& now,
                 const SurfaceTree& surface, double reach_m);

}  // namespace fissure
