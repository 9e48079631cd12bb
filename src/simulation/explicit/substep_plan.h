#pragma once

#include "base/scene.h"
#include "scenario/bodies.h"

namespace fissure {

/// What a step of an elastic body costs, known without running it.
struct SubstepPlan {
  std::size_t tetrahedra = 0;
  double critical_step_s = 0;  ///< largest stable substep of the body at rest
  int substeps = 0;            ///< of a step at rest; more while elements are stretched
};

/// For a body whose scene has its volume. Throws InputError where this machine cannot run it.
SubstepPlan planSubsteps(const BodySettings& settings, const SceneBody& body, double step_s);

}  // namespace fissure
