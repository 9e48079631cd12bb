#pragma once

#include <filesystem>

#include "base/geometry.h"
#include "scenario/bodies.h"

namespace fissure {

/// A shape's surface in its own frame, metres. A file's is repaired and subdivided as asked (loadSurface,
/// which says what is thrown). `directory`: where relative file names start.
TriangleMesh makeSurface(const SurfaceShape& shape, const std::filesystem::path& directory = ".");

/// The surface of a soft body as its scenario places it, scene frame, metres: the shape turned by the body's
/// orientation about its own origin, then moved to the body's position. Triangles given as arrays keep their
/// order and indices.
TriangleMesh placeBody(const BodySettings& body, const std::filesystem::path& directory = ".");

/// The same from a surface in the shape's own frame that is at hand.
TriangleMesh placeBody(const BodySettings& body, TriangleMesh shape);

}  // namespace fissure
