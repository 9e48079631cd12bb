#pragma once

#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/shapes.h"

namespace fissure {

/// Does `repairs` in the order of MeshRepair, and no other. Returns what they
/// changed, a line each: "cap_holes: 2 holes of 60 edges"; a repair that found nothing to do has none.
/// Vertices that lose their last triangle go with it.
///   - drop_duplicate_faces: of triangles with the same corners one stays; where as many run one way round as
///     the other, none, because they bound nothing;
///   - orient: neighbours across edges of two triangles are made to agree, the fewer turned; at the end
///   closed
///     pieces are turned outward, inward where they are a cavity of another one. What has only one side
///     (a Moebius strip) stays as it is;
///   - cap_holes: a loop of three boundary edges by a triangle, a longer one by a fan around the mean of its
///     vertices. Loops that touch themselves or run against each other stay open.
/// All vertices must be finite, all indices good.
std::vector<std::string> repairMesh(TriangleMesh& mesh, const std::vector<MeshRepair>& repairs);

}  // namespace fissure
