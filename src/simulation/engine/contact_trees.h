#pragma once

#include <BulletSoftBody/btSoftBody.h>

namespace fissure {

/// Builds the bounding-volume trees of a body in pieces for soft contact of vertices. Bullet builds them by
/// merging neighbours, vertices along links and triangles along edges, until one tree of each kind is left,
/// which never ends for a body in pieces: several shells, or a fixed vertex without links because all of its
/// neighbours are fixed too. For such a body this function inserts leaf after leaf, as Bullet does for a new
/// body, so that Bullet builds none. Other bodies are not changed. Call it when the body is complete.
void makeTreesOfPieces(btSoftBody& body);

}  // namespace fissure
