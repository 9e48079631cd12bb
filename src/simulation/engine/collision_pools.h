#pragma once

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

namespace fissure {

/// Bullet's pools for pairs of objects that are near each other. By default it allocates and clears them for
/// 4,096 pairs when a world is made, a third of all that a run of ten steps does. A scene has a few objects;
/// what a pool has no room for, Bullet allocates singly.
inline btDefaultCollisionConstructionInfo collisionPools() {
  constexpr int pairs = 64;
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = pairs;
  info.m_defaultMaxCollisionAlgorithmPoolSize = pairs;
  return info;
}

}  // namespace fissure
