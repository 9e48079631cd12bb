#pragma once

#include <vector>

#include "surface/surface_tree.h"

namespace fissure {

/// The passage of a moving point through a moving triangle. Vectors in the tree's frame.
struct Crossing {
  double time = 0;                ///< share of the step, 0..1
  bool entering = false;          ///< the point moves against the triangle's outward normal
  Vec3 normal = Vec3::Zero();     ///< outward normal at that time, not of unit length
  Vec3 direction = Vec3::Zero();  ///< motion of the point relative to the triangle in the step, metres
};

/// Finds all crossings, in order of time, of a point that moves straight from `from` to `to` (tree's frame,
/// metres) during the last update of the tree, while every vertex moves straight from its previous to its
/// present position. A path through an edge is reported by one or by both of its triangles, never by none.
/// `crossings` is overwritten. Returns the number of triangles tested, a measure of cost.
std::size_t findCrossings(const SurfaceTree& tree, const Vec3& from, const Vec3& to,
                          std::vector<Crossing>& crossings);

}  // namespace fissure
