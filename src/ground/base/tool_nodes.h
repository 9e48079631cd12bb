#pragma once

#include <vector>

#include "base/geometry.h"

namespace fissure {

/// The nodes of one tool, in the tool's frame (Fukuhara et al. 2014; contact/METHOD.md 2). All four arrays
/// have one entry per node.
struct ToolNodes {
  std::vector<Vec3> positions_m;
  std::vector<Vec3> normals;  ///< unit vectors, out of the tool
  std::vector<int> partners;  ///< index of the node across the tool; -1: none. Need not be mutual.
  /// Thickness of the tool from the node to its partner; infinity without one.
  std::vector<double> thicknesses_m;
  /// True for a box with nodes on all six sides. Each tissue triangle is then left to the side that it faces
  /// most; otherwise nodes along a rim would push sideways what lies below the rim.
  bool all_sides = false;

  int size() const { return static_cast<int>(positions_m.size()); }
};

/// State of a tool node in a step. The values are stored in result files: never renumber them.
enum class NodeState : unsigned char {
  free = 0,        ///< no candidate contact
  feasible = 1,    ///< its contact acts on the tissue
  infeasible = 2,  ///< a candidate that its partner excludes in this step
  capped = 3,      ///< its contact acts, but its displacement was limited to that of one step
};

}  // namespace fissure
