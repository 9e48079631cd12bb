#pragma once

#include "base/geometry.h"
#include "scenario/bodies.h"

namespace fissure {

/// The surface of a soft body as its scenario places it, scene frame, metres.
TriangleMesh placeBody(const BodySettings& body);

}  // namespace fissure
