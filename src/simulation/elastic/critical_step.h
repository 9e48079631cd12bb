#pragma once

#include <span>

#include "elastic/element_forces.h"

namespace fissure {

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
class CriticalStep {
 public:
  /// Leaves nothing of value in the slots of `forces`. Fixed vertices have an inverse mass of 0.
  CriticalStep(ElementForces& forces, const ElasticMaterial& material,
               std::span<const double> inverse_masses_1_kg);

  /// For growths of stiffness and damping since rest, each at least 1. Infinite where all vertices are fixed.
  double step_s(double stiffness_growth, double viscous_growth) const;

 private:
  double stiffness_1_s2_ = 0;  ///< omega squared
  double damping_1_s_ = 0;     ///< 2 xi omega
};

}  // namespace fissure
