#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

namespace fissure {

/// Shows Bullet's solve the ground of a method whose own contacts follow it: vertices predicted below the
/// ground go through the solve from its plane, and afterwards are taken back by as much, position and motion
/// alike. So the tissue's links are solved as on the ground they are about to be put on, and all that the
/// ground gives the tissue is in those contacts. Without it links that hang through the ground give way over
/// long steps.
class GroundPreview {
 public:
  explicit GroundPreview(double height_m) : height_m_(height_m) {}

  /// Before the solve, after Bullet's prediction.
  void lift(btAlignedObjectArray<btSoftBody*>& bodies);
  /// After it.
  void takeBack(btAlignedObjectArray<btSoftBody*>& bodies) const;

 private:
  double height_m_;
  std::vector<btScalar> lifts_m_;  ///< one a vertex, body by body
};

}  // namespace fissure
