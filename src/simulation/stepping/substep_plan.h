#pragma once

#include <vector>

#include "base/scene.h"
#include "scenario/bodies.h"

namespace fissure {

/// The share of one region of an elastic body.
struct RegionPlan {
  std::size_t tetrahedra = 0;
  double critical_step_s = 0;  ///< at rest, if only its material had stiffness and viscosity
};

/// The cost of a step of an elastic body, known without running it (elastic/METHOD.md 6).
struct SubstepPlan {
  std::size_t tetrahedra = 0;
  double critical_step_s = 0;       ///< largest stable substep of the body at rest
  int substeps = 0;                 ///< for a step at rest; more while elements are stretched
  std::vector<RegionPlan> regions;  ///< in the body's order
  std::size_t stiffest = 0;         ///< number of tetrahedra in the stiffest hundredth (stiffestElements)
  Vec3 stiffest_m = Vec3::Zero();   ///< centroid of the stiffest of them, scene frame
  int substeps_without_stiffest = 0;
};

/// Throws InputError where this machine cannot run an elastic body, which must have its volume, in such
/// steps.
void checkSubsteps(const BodySettings& settings, const SceneBody& body, double step_s);
/// The plan for a body and a time step, at several times the cost of checkSubsteps(), which it includes.
SubstepPlan planSubsteps(const BodySettings& settings, const SceneBody& body, double step_s);

}  // namespace fissure
