#pragma once

#include "base/geometry.h"
#include "scenario/bodies.h"

namespace fissure {

/// The surface of a soft body as its scenario places it, scene frame, metres: the shape turned by the body's
/// orientation about its own origin, then moved to the body's position. Triangles given as arrays keep their
/// order and indices.
TriangleMesh placeBody(const BodySettings& body);

}  // namespace fissure
