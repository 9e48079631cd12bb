#pragma once

#include "base/geometry.h"
#include "scenario/elastic.h"
#include "volume/tetrahedra_file.h"

namespace fissure {

/// Fills a closed surface with outward faces, metres, with tetrahedra, by TetGen (Si 2015) run as a process
/// of its own: a constrained Delaunay mesh, refined and optimised as `settings` asks. Where the surface is
/// kept, the volume's surface is `surface`, bit for bit. The same input gives the same mesh. Throws
/// InputError where TetGen finds none (a surface that crosses or touches itself), or none within two minutes
/// or 2,097,152 tetrahedra; RunError where it is not installed.
BoundedVolume fillWithTetrahedra(const TriangleMesh& surface, const FillSettings& settings);

}  // namespace fissure
