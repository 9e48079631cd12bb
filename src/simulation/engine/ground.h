#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletSoftBody/btSoftBody.h>

#include <optional>

#include "scenario/scenario.h"

namespace fissure {

/// The analytic half-space under the tissue, the same in every pipeline that leaves the ground to Bullet:
/// before each solve, every vertex closer to the ground than the body's margin gets one of Bullet's own
/// soft-rigid contacts against a static body (engine/METHOD.md 2).
class Ground {
 public:
  explicit Ground(const GroundSettings& settings);

  /// Appends the contacts of `body`, at its predicted positions, for the next solve.
  void addContacts(btSoftBody& body);

 private:
  GroundSettings settings_;
  btRigidBody plane_;  ///< represents the ground in contacts; it is in no world and has no shape
};

}  // namespace fissure
