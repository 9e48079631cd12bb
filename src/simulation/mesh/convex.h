#pragma once

#include "base/geometry.h"

namespace fissure {

/// True when no vertex lies in front of a triangle's plane by more than a ten-thousandth of the surface's
/// extent. The surface must be closed (hasInside). Planes of slivers are ignored, because their normals are
/// unreliable.
bool isConvex(const TriangleMesh& mesh);

}  // namespace fissure
