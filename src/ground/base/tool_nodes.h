#pragma once

#include <vector>

#include "base/geometry.h"

namespace fissure {

/// The nodes of one tool, in the tool's frame (Fukuhara et al. 2014; METHOD: tool nodes and their partners).
/// All four arrays have one entry a node.
struct ToolNodes {
  std::vector<Vec3> positions_m;
  std::vector<Vec3> normals;          ///< unit, out of the tool
  std::vector<int> partners;          ///< index of the node across the tool; -1: none. Need not be mutual.
  std::vector<double> thicknesses_m;  ///< between the node and its partner; infinity where there is none
  /// Of a box with nodes on all six sides: tissue is left to the side that it faces most, or the nodes along
  /// a rim would push aside what lies below it.
  bool all_sides = false;

  int size() const { return static_cast<int>(positions_m.size()); }
};

/// What a tool node did in a step. The values are stored in result files: never renumber.
enum class NodeState : unsigned char {
  free = 0,        ///< no candidate contact
  feasible = 1,    ///< its contact acts on the tissue
  infeasible = 2,  ///< a candidate that its pair excludes in this step
  capped = 3,      ///< acts, but its displacement hit the limit of one step
};

}  // namespace fissure
