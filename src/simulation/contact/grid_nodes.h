#pragma once

#include <array>

#include "base/tool_nodes.h"

namespace fissure {

/// Nodes of a box tool (Fukuhara et al. 2014; contact/METHOD.md 2), in the tool's frame: a regular grid on
/// each of the two largest faces of a box centred on its origin. Facing nodes are mutual partners, and the
/// thickness is the box's smallest edge. size_m: full edge lengths; resolution: number of nodes along the
/// longer and the shorter edge of a large face. The outer nodes stand on the border of the face: with nodes
/// in the middle of cells tissue slips round the edges of the tool (8 x 8 on a 40 x 15 mm spatula at 0.1 m/s:
/// 2.1 mm deep instead of 0.2). The nodes of the face on the positive side come first, then those of the
/// other face in the same order. narrow_rows > 0, which is not in the paper, appends this number of rows on
/// each of the four narrow faces, with partners across the tool and as many nodes along a row as on a large
/// face.
ToolNodes makeGridNodes(const Vec3& size_m, const std::array<int, 2>& resolution, int narrow_rows = 0);

}  // namespace fissure
