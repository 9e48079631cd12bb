#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletSoftBody/btSoftBody.h>

#include <optional>

#include "scenario/scenario.h"

namespace fissure {

/// The analytic half-space under the tissue, the same in every pipeline that leaves the ground to Bullet:
/// before each solve, every vertex closer to the ground than the body's margin gets one of Bullet's own
/// soft-rigid contacts against a static body (METHOD: facts about Bullet).
class Ground {
 public:
  explicit Ground(const GroundSettings& settings);

  /// Appends the contacts of `body` for the coming solve; positions are the predicted ones.
  void addContacts(btSoftBody& body);

 private:
  GroundSettings settings_;
  btRigidBody plane_;  ///< stands for the ground in the contacts; belongs to no world and has no shape
};

}  // namespace fissure
