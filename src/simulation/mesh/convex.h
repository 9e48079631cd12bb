#pragma once

#include "base/geometry.h"

namespace fissure {

/// True when no vertex lies in front of a triangle's plane by more than a ten-thousandth of the surface's
/// extent. Of closed surfaces (hasInside). Slivers, whose normals cannot be trusted, are not asked.
bool isConvex(const TriangleMesh& mesh);

}  // namespace fissure
