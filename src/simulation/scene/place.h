#pragma once

#include "base/scene.h"
#include "scenario/bodies.h"
#include "volume/mesh_files.h"

namespace fissure {

/// The surface of a shape in its own frame, metres. A surface from a file is repaired and subdivided as the
/// shape asks; for a file of tetrahedra it is their boundary. Throws as loadSurface and readTetrahedra.
TriangleMesh makeSurface(const SurfaceShape& shape, const MeshFiles& files = MeshFiles("."));

/// The surface of a soft body as placed at time zero, scene frame, metres: the shape is turned by the body's
/// orientation about its own origin, then moved to the body's position. Triangles given as arrays keep their
/// order and indices. For an elastic body whose surface the mesher may cut it is the surface of the filled
/// volume. Throws as makeSurface and MeshFiles::filled.
TriangleMesh placeBody(const BodySettings& body, const MeshFiles& files = MeshFiles("."));

/// The volume of an elastic body placed in the same way, with its fixed vertices and regions; its first
/// vertices are those of placeBody. Throws InputError as MeshFiles::volume, MeshFiles::filled and
/// volumeRegions() do.
SceneVolume placeVolume(const BodySettings& body, const MeshFiles& files = MeshFiles("."));

}  // namespace fissure
