#pragma once

#include <string>
#include <vector>

#include "base/geometry.h"
#include "scenario/shapes.h"

namespace fissure {

/// Applies `repairs` in the order of MeshRepair. Returns their changes, one line each, as "cap_holes: 2 holes
/// of 60 edges"; a repair that changes nothing has no line. Vertices that lose their last triangle are
/// removed.
///   - drop_duplicate_faces: of triangles with the same corners one is kept; none where equally many have
///     either orientation, because these bound nothing;
///   - orient: neighbours across edges of two triangles get the same orientation (orientConsistently); then
///     closed pieces are turned outward, or inward where they are a cavity of another one. One-sided surfaces
///     (a Moebius strip) stay unchanged;
///   - cap_holes: a loop of three boundary edges is closed by a triangle, a longer one by a fan around the
///     mean of its vertices. Loops that touch themselves or have inconsistent directions stay open.
/// All vertices must be finite and all indices valid.
std::vector<std::string> repairMesh(TriangleMesh& mesh, const std::vector<MeshRepair>& repairs);

}  // namespace fissure
