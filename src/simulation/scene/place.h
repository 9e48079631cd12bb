#pragma once

#include "base/scene.h"
#include "mesh/file_surface.h"
#include "scenario/bodies.h"

namespace fissure {

/// A shape's surface in its own frame, metres. A file's is repaired and subdivided as asked (loadSurface,
/// which says what is thrown).
TriangleMesh makeSurface(const SurfaceShape& shape, const SurfaceFiles& files = SurfaceFiles("."));

/// The surface of a soft body as its scenario places it, scene frame, metres: the shape turned by the body's
/// orientation about its own origin, then moved to the body's position. Triangles given as arrays keep their
/// order and indices.
TriangleMesh placeBody(const BodySettings& body, const SurfaceFiles& files = SurfaceFiles("."));

/// The volume of an elastic body likewise, and which of its vertices are fixed; its first vertices are those
/// of placeBody. The body's shape must have a volume (tetrahedraOf).
SceneVolume placeVolume(const BodySettings& body);

}  // namespace fissure
