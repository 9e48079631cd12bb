#pragma once

#include <BulletSoftBody/btSoftBody.h>

namespace fissure {

/// Pose matching of a body that is too small for Bullet's own (engine/METHOD.md 3). Bullet turns the rest
/// shape by the rotation in the polar decomposition of a matrix in square metres. Where the product of two
/// norms of the matrix is below the precision's epsilon, Bullet takes it for singular and uses it as the
/// rotation: for spheres of less than 32 mm radius in single precision and 0.2 mm in double precision. The
/// body is then drawn to a point. Here the matrix is first scaled to a size of about one; all else is as in
/// Bullet.
class PoseMatching {
 public:
  /// Whether the body has pose matching and is that small at rest. A body that becomes so only under load
  /// keeps Bullet's own matching.
  static bool isNeededFor(const btSoftBody& body);

  /// Takes over the matching and switches Bullet's own off (kMT = 0). The body must outlive this object.
  explicit PoseMatching(btSoftBody& body);

  /// Moves the free vertices by the share kMT of their distances to the matched shape. To be called after
  /// Bullet's predictMotion, whose last part is Bullet's own matching.
  void apply() const;

 private:
  btSoftBody* body_;
  btScalar share_;  ///< kMT of the scenario
  btScalar scale_;  ///< 1 / m^2
};

}  // namespace fissure
