#pragma once

#include <span>
#include <vector>

#include "elastic/element_forces.h"

namespace fissure {

/// How much stiffer and more viscous than at rest a material is, each at least 1.
struct Growth {
  double stiffness = 1;
  double viscous = 1;
};

/// What sets the largest stable step of vibrations.
struct StepLimit {
  double stiffness_1_s2 = 0;  ///< omega squared
  double damping_1_s = 0;     ///< 2 xi omega

  double step_s() const;  ///< infinite without a stiffness
};

/// The largest stable substep of symplectic Euler: with the stiffness K, the damping C and the masses M, h^2
/// K + 2 h C must stay below 4 M (for one vibration h < (2 / omega) (sqrt(1 + xi^2) - xi), Belytschko, Liu,
/// Moran 2000, 6.2). omega is that of the whole mesh, found by the Lanczos method (power iteration that keeps
/// its whole sequence), to about 1e-5 and from below: the height of the smallest element over the speed of
/// waves is unsafe for some meshes and three times too small for others.
///
/// Stretched tissue is stiffer. Its omega^2 is taken as that of rest times the growth of the stiffness of the
/// stiffest wave in the most deformed element, by the material's tangent in the coordinates of rest, where an
/// element that gets flatter is one whose areas weigh more; damping grows as the square of the largest
/// stretch s. With a the largest growth of an area and T = tr(R^T F), the growth is M / M(rest),
///   neo-Hookean: M = mu' (I_C / (I_C + 1) + 2 s^2 / (I_C + 1)^2) + lambda' (a^2 + max(0, J - 1) s),
///   corotated:   M = lambda + 2 mu + max(0, 2 (lambda (T - 3) - 2 mu) / (T - s)).
/// That is an estimate, not a bound. Of homogeneous stretches between a half and 2 it was at most 0.5 % above
/// the true limit and at least half of it; 1.5 laterally halves the limit.
///
/// Of several materials each has growths of its own. The mesh's omega^2 then grows at most as much as the
/// most grown material's, and by no more than the sum of what each material's stiffness alone would add: the
/// largest eigenvalue of a sum is at most the sum of theirs. The lesser of the two is taken, so that soft
/// tissue that is stretched costs nothing while a stiff vessel sets the step. Damping likewise.
class CriticalStep {
 public:
  /// Leaves nothing of value in the slots of `forces`. Fixed vertices have an inverse mass of 0.
  CriticalStep(ElementForces& forces, std::span<const double> inverse_masses_1_kg);

  /// For growths since rest, one a material. Infinite where all vertices are fixed.
  double step_s(std::span<const Growth> growths) const;

 private:
  StepLimit all_;
  /// Of several materials, one each: the largest eigenvalues of its stiffness and its damping alone.
  std::vector<StepLimit> alone_;
};

/// The largest stable substep at rest if of all materials only this one had a stiffness and a viscosity, and
/// there was no mass damping. Infinite where its vertices are all fixed. Leaves nothing of value in the
/// slots.
double criticalStepAlone_s(ElementForces& forces, std::span<const double> inverse_masses_1_kg,
                           std::size_t material);

}  // namespace fissure
