#pragma once

#include <vector>

#include "surface/surface_tree.h"

namespace fissure {

/// A moving point goes through a moving triangle. Vectors in the tree's frame.
struct Crossing {
  double time = 0;                ///< share of the step, 0..1
  bool entering = false;          ///< against the triangle's outward normal
  Vec3 normal = Vec3::Zero();     ///< outward at that time, not of unit length
  Vec3 direction = Vec3::Zero();  ///< motion of the point relative to the triangle in the step, metres
};

/// Every crossing, in order of time, of a point on the straight way `from` to `to` (tree's frame, metres)
/// during the last update of the tree, with every vertex going straight from its previous to its present
/// position meanwhile. A path through an edge is reported by one or by both of its triangles, never by none.
/// `crossings` is overwritten. Returns how many triangles had to be looked at: what that costs.
std::size_t findCrossings(const SurfaceTree& tree, const Vec3& from, const Vec3& to,
                          std::vector<Crossing>& crossings);

}  // namespace fissure
