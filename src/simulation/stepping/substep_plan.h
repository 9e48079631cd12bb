#pragma once

#include <vector>

#include "base/scene.h"
#include "scenario/bodies.h"

namespace fissure {

/// A region of an elastic body.
struct RegionPlan {
  std::size_t tetrahedra = 0;
  double critical_step_s = 0;  ///< at rest, if its material alone had a stiffness and a viscosity
};

/// What a step of an elastic body costs, known without running it.
struct SubstepPlan {
  std::size_t tetrahedra = 0;
  double critical_step_s = 0;       ///< largest stable substep of the body at rest
  int substeps = 0;                 ///< of a step at rest; more while elements are stretched
  std::vector<RegionPlan> regions;  ///< in the body's order
  std::size_t stiffest = 0;         ///< tetrahedra: the stiffest of each hundred (stiffestElements)
  Vec3 stiffest_m = Vec3::Zero();   ///< centroid of the stiffest of them, scene frame
  int substeps_without_stiffest = 0;
};

/// For a body whose scene has its volume. Throws InputError where this machine cannot run it.
SubstepPlan planSubsteps(const BodySettings& settings, const SceneBody& body, double step_s);

}  // namespace fissure
