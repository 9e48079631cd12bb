#pragma once

#include <LinearMath/btTransform.h>

#include "base/geometry.h"

namespace fissure {

inline btVector3 toBullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
inline Vec3 fromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

inline btTransform toBullet(const Pose& pose) {
  const Quat& q = pose.orientation;
  return btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                  static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                     toBullet(pose.position_m));
}

}  // namespace fissure
