#pragma once

#include <BulletSoftBody/btSoftBody.h>

namespace fissure {

/// Pose matching of a body that is too small for Bullet's own. Bullet turns the rest shape by the rotation of
/// a matrix in square metres, and takes that matrix for singular, and as it is for the rotation, where the
/// product of two of its norms is below the precision's epsilon: in single precision a sphere of less than
/// 32 mm radius, in double precision one of 0.2 mm. The rest shape that the body is drawn to is then a point.
/// Here the matrix is scaled to the size of one first; all else is Bullet's.
class PoseMatching {
 public:
  /// Whether the body is matched, and at rest so small. (One that becomes so only while it is pressed stays
  /// with Bullet's own.)
  static bool isNeededFor(const btSoftBody& body);

  /// Takes the matching over: Bullet's own is switched off (kMT = 0). The body must outlive this.
  explicit PoseMatching(btSoftBody& body);

  /// Moves the vertices that are not fixed by their share of the way to the matched shape. After Bullet's
  /// predictMotion, which ends with its own.
  void apply() const;

 private:
  btSoftBody* body_;
  btScalar share_;  ///< kMT of the scenario
  btScalar scale_;  ///< 1 / m^2
};

}  // namespace fissure
