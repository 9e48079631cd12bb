#pragma once

#include <span>
#include <vector>

#include "elastic/element_forces.h"

namespace fissure {

/// Stiffness and viscous damping of a deformed material over those at rest, each at least 1.
struct Growth {
  double stiffness = 1;
  double viscous = 1;
};

/// The largest eigenvalues that limit the stable step of explicit integration (elastic/METHOD.md 5).
struct StepLimit {
  double stiffness_1_s2 = 0;  ///< omega squared
  double damping_1_s = 0;     ///< 2 xi omega

  double step_s() const;  ///< largest stable step, seconds; infinite without a stiffness
};

/// The largest stable substep h of symplectic Euler (elastic/METHOD.md 5): with the stiffness K, the damping
/// C and the masses M, h^2 K + 2 h C must stay below 4 M (for one vibration h < (2 / omega) (sqrt(1 + xi^2) -
/// xi), Belytschko, Liu, Moran 2000, 6.2). omega is the largest of the whole mesh, found by the Lanczos
/// method to about 1e-5 and from below. The usual estimate, the height of the smallest element over the wave
/// speed, is unsafe for some meshes and three times too small for others.
///
/// Stretched tissue is stiffer. Its omega^2 is taken as that of rest times the growth of the stiffness of the
/// stiffest wave in the most deformed element, by the material's tangent in the coordinates of rest, where an
/// element that gets flatter is one whose areas weigh more; damping grows as the square of the largest
/// stretch s. With a the largest growth of an area and T = tr(R^T F), the growth is M / M(rest),
///   neo-Hookean: M = mu' (I_C / (I_C + 1) + 2 s^2 / (I_C + 1)^2) + lambda' (a^2 + max(0, J - 1) s),
///   corotated:   M = lambda + 2 mu + max(0, 2 (lambda (T - 3) - 2 mu) / (T - s)),
///   Saint Venant-Kirchhoff: M = (lambda + 2 mu) s^2 + 2 max(0, mu (s^2 - 1) + lambda (|F|^2 - 3) / 2).
/// That is an estimate, not a bound. Of homogeneous stretches between a half and 2 it was at most 0.5 % above
/// the true limit and at least half of it (a quarter for compressed Saint Venant-Kirchhoff tissue, which
/// softens); 1.5 laterally halves the limit.
///
/// With several materials each has its own growth. Two bounds hold for the growth of the mesh's omega^2: the
/// largest growth of any material, and the sum of what each material's stiffness alone would add, because the
/// largest eigenvalue of a sum is at most the sum of the largest eigenvalues. The smaller of the two is
/// taken, so that stretched soft tissue costs nothing while a stiff vessel limits the step. The same holds
/// for damping.
class CriticalStep {
 public:
  /// Overwrites the slots of `forces`. inverse_masses_1_kg: [vertex], 0: fixed.
  CriticalStep(ElementForces& forces, std::span<const double> inverse_masses_1_kg);

  /// The largest stable substep, seconds, for growths since rest (one per material). Infinite where all
  /// vertices are fixed.
  double step_s(std::span<const Growth> growths) const;

 private:
  StepLimit all_;
  /// For several materials, one entry each: the largest eigenvalues of its stiffness and damping alone.
  std::vector<StepLimit> alone_;
};

/// The largest stable substep at rest, seconds, if only the material with this number had a stiffness and a
/// viscosity, and without mass damping. Infinite where all of its vertices are fixed. Overwrites the slots of
/// `forces`.
double criticalStepAlone_s(ElementForces& forces, std::span<const double> inverse_masses_1_kg,
                           std::size_t material);

}  // namespace fissure
