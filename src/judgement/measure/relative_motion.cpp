#include "measure/relative_motion.h"

#include <algorithm>
#include <cmath>

namespace fissure {

double longestWay_m(const SurfaceTree& surface) {
  double squared = 0;
  for (std::size_t i = 0; i < surface.triangles().size(); ++i) {
    const TreeTriangle &now = surface.triangles()[i], &before = surface.previous()[i];
    squared = std::max({squared, (now.a - before.a).squaredNorm(), (now.b - before.b).squaredNorm(),
                        (now.c - before.c).squaredNorm()});
  }
  return std::sqrt(squared);
}

// The way of a point is convex over a rigid body: longest at a corner of a box around it.
double longestWay_m(const TreeBox& extent, const ToolPlacement& before, const ToolPlacement& now) {
  double way_m = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1 ? extent.high : extent.low).x(), (corner & 2 ? extent.high : extent.low).y(),
                     (corner & 4 ? extent.high : extent.low).z());
    way_m = std::max(way_m, (now.of(point) - before.of(point)).norm());
  }
  return way_m;
}

// The trace of a rotation by an angle is 1 + 2 cos(angle).
bool turnIsAcute(const ToolPlacement& before, const ToolPlacement& now) {
  return (before.rotation.transpose() * now.rotation).trace() >= 1;
}

// Of the points of a triangle a corner goes farthest.
double nearWay_m(const TreeBox& extent, const ToolPlacement& before, const ToolPlacement& now,
                 const SurfaceTree& surface, double reach_m) {
  const auto toTool = [](const ToolPlacement& placement, const Vec3& point) {
    return Vec3(placement.rotation.transpose() * (point - placement.origin_m));
  };
  const Vec3 centre = (extent.low + extent.high) / 2, half = (extent.high - extent.low) / 2;
  const Vec3 around = before.rotation.cwiseAbs() * half;
  const Vec3 low = before.of(centre) - around, high = before.of(centre) + around;
  double squared = 0;
  const std::size_t end = surface.nodes().size();
  for (std::size_t i = 0; i < end;) {
    const TreeNode& node = surface.nodes()[i];
    const TreeBox& box = surface.previousBoxes()[i];
    if ((box.low - high).cwiseMax(low - box.high).maxCoeff() > reach_m) {
      i = static_cast<std::size_t>(node.skip);
      continue;
    }
    ++i;
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      const std::size_t index = static_cast<std::size_t>(node.first) + k;
      const TreeTriangle &after = surface.triangles()[index], &previous = surface.previous()[index];
      for (const auto corner : {&TreeTriangle::a, &TreeTriangle::b, &TreeTriangle::c}) {
        const Vec3 way = toTool(now, after.*corner) - toTool(before, previous.*corner);
        squared = std::max(squared, way.squaredNorm());
      }
    }
  }
  return std::sqrt(squared);
}

}  // namespace fissure
