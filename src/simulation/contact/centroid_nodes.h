#pragma once

#include "base/tool_nodes.h"

namespace fissure {

struct CentroidNodeSettings {
  /// Largest length of a pairing ray over the tool's thickness in the middle of the ray, > 0.
  double pairing_limit = 3;
  /// Whether triangles with a longer ray get a node too, without a partner.
  bool lone_nodes = false;
  /// Whether there are rim nodes (see below).
  bool rim_nodes = true;
};

/// Nodes, in the tool's frame, of any tool with a consistently oriented surface (contact/METHOD.md 2): one at
/// the centroid of each triangle, with the triangle's normal. A ray from the centroid into the tool leaves
/// the tool through some triangle, whose node is the partner; the length of the ray is the thickness.
/// Association need not be mutual. Where the ray runs along a thin tool instead of across it, as from the
/// triangles of a side edge, it is longer than the limit, and the triangle has no node, which would push
/// tissue sideways out from under the tool. Rim nodes, which are not in the paper, stand at the corners where
/// triangles with a node meet triangles without one, or meet each other at more than 60 degrees; without them
/// tissue can slip round there.
ToolNodes makeCentroidNodes(const TriangleMesh& surface, const CentroidNodeSettings& settings = {});

}  // namespace fissure
