#pragma once

#include "base/scene.h"
#include "scenario/bodies.h"
#include "volume/mesh_files.h"

namespace fissure {

/// A shape's surface in its own frame, metres. A file's is repaired and subdivided as asked (loadSurface,
/// which says what is thrown), or the boundary of its tetrahedra (readTetrahedra likewise).
TriangleMesh makeSurface(const SurfaceShape& shape, const MeshFiles& files = MeshFiles("."));

/// The surface of a soft body as its scenario places it, scene frame, metres: the shape turned by the body's
/// orientation about its own origin, then moved to the body's position. Triangles given as arrays keep their
/// order and indices. Of an elastic body whose surface the mesher may cut: what it made of it
/// (MeshFiles::filled says what is thrown).
TriangleMesh placeBody(const BodySettings& body, const MeshFiles& files = MeshFiles("."));

/// The volume of an elastic body likewise, which of its vertices are fixed, and its regions; its first
/// vertices are those of placeBody. Throws InputError as MeshFiles::volume, MeshFiles::filled and
/// volumeRegions() do.
SceneVolume placeVolume(const BodySettings& body, const MeshFiles& files = MeshFiles("."));

}  // namespace fissure
