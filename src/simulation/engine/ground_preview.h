#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

namespace fissure {

/// Lets Bullet's solve take account of a ground whose contacts are solved afterwards by a contact method.
/// Vertices that are predicted below the ground are lifted onto its plane for the solve and moved back by the
/// same amount afterwards, in position and motion. So links are solved as if the tissue were on the ground,
/// while the whole reaction of the ground comes from the contacts of the method. Without it, links that hang
/// through the ground yield over long steps.
class GroundPreview {
 public:
  explicit GroundPreview(double height_m) : height_m_(height_m) {}

  /// To be called before the solve, after Bullet's prediction.
  void lift(btAlignedObjectArray<btSoftBody*>& bodies);
  /// To be called after the solve.
  void takeBack(btAlignedObjectArray<btSoftBody*>& bodies) const;

 private:
  double height_m_;
  std::vector<btScalar> lifts_m_;  ///< [vertex] of all bodies
};

}  // namespace fissure
