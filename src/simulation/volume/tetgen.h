#pragma once

#include "base/geometry.h"
#include "scenario/elastic.h"
#include "volume/tetrahedra_file.h"

namespace fissure {

/// Fills a closed surface with outward faces, in metres, with tetrahedra: a constrained Delaunay mesh by
/// TetGen (Si 2015), run as a process of its own, refined and optimised by `settings` (elastic/METHOD.md 9).
/// With keep_surface the volume's surface equals `surface` bit for bit. The same input gives the same mesh.
/// Throws InputError where TetGen finds none (a surface that crosses or touches itself), or none within two
/// minutes or 2,097,152 tetrahedra; RunError where it is not installed.
BoundedVolume fillWithTetrahedra(const TriangleMesh& surface, const FillSettings& settings);

}  // namespace fissure
