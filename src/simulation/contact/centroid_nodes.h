#pragma once

#include "base/tool_nodes.h"

namespace fissure {

struct CentroidNodeSettings {
  /// The longest pairing ray, in thicknesses of the tool in the middle of the ray, > 0.
  double pairing_limit = 3;
  /// Triangles whose ray is longer get a node all the same, without a partner.
  bool lone_nodes = false;
  /// Also nodes on the rim of what carries nodes.
  bool rim_nodes = true;
};

/// Nodes of any tool with a consistently oriented surface (the paper's extension to convex thin tools;
/// METHOD: tool nodes and their partners): one at the centroid of each triangle, with the triangle's normal.
/// Its partner is the node of the first triangle that a ray from the centroid into the tool leaves the tool
/// through; association need not be mutual. thickness = the ray's length. Where the ray runs along a thin
/// tool instead of across it, as from the triangles of a side edge, it is longer than the limit, and the
/// triangle has no node: it would push tissue sideways out from under the tool.
/// Rim nodes (beyond the paper): at the corners where triangles with nodes meet such without, or one another
/// at more than 60 degrees; centroids alone leave tissue room to slip round there.
ToolNodes makeCentroidNodes(const TriangleMesh& surface, const CentroidNodeSettings& settings = {});

}  // namespace fissure
