#pragma once

#include <BulletSoftBody/btSoftBody.h>

namespace fissure {

/// For contact of vertices Bullet merges neighbours, vertices along links and triangles along edges, until
/// one tree is left of each, and never ends where a body is in pieces: several shells, or a fixed vertex that
/// lost its links because all its neighbours are fixed too. For such a body this makes the trees by inserting
/// leaf after leaf, as Bullet itself does for a new body, so that Bullet makes none. Others stay as they are.
/// Call it when the body is complete.
void makeTreesOfPieces(btSoftBody& body);

}  // namespace fissure
