#pragma once

// Moves the vertices by symplectic Euler, for one instruction set. Internal linkage, as in lanes.h.

#include "elastic/element_kernels.h"
#include "elastic/lanes.h"

namespace fissure {
namespace {

/// The sum of the slots first[0] to first[1] - 1.
inline void sumSlots(const double* slots, const int* first, double (&sum)[4]) {
#if FISSURE_LANE_WIDTH > 2
  Four found = {};
  for (long slot = first[0]; slot < first[1]; ++slot) found += load<Four>(slots + 4 * slot);
  store(found, sum);
#else
  Two low = {};
  double high = 0;
  for (long slot = first[0]; slot < first[1]; ++slot) {
    low += load<Two>(slots + 4 * slot);
    high += slots[4 * slot + 2];
  }
  store(low, sum);
  sum[2] = high;
#endif
}

void moveVertices(const ElementArrays& arrays, MovePass& pass) {
  const double h = pass.substep_s;
  double viscous_work_J = 0, damping_loss_J = 0;
  for (int vertex = 0; vertex < arrays.vertices; ++vertex) {
    const double inverse_mass = pass.inverse_masses_1_kg[vertex];
    if (inverse_mass == 0) continue;
    double force[4] = {}, viscous[4] = {};
    sumSlots(pass.forces_N, arrays.first_slots + vertex, force);
    if (pass.viscous_forces_N != nullptr)
      sumSlots(pass.viscous_forces_N, arrays.first_slots + vertex, viscous);
    double damped = 0;
    for (int i = 0; i < 3; ++i) {
      const long at = 3L * vertex + i;
      const double before = pass.velocities_m_s[at];
      const double acceleration =
          (force[i] + viscous[i]) * inverse_mass + (pass.gravity_m_s2[i] - pass.mass_damping_1_s * before);
      const double after = before + h * acceleration, mean = 0.5 * (before + after);
      pass.velocities_m_s[at] = after;
      pass.accelerations_m_s2[at] = acceleration;
      pass.positions_m[at] += h * after;
      damped += before * mean;
      if (pass.viscous_forces_N != nullptr) {
        pass.viscous_sums_N[at] = viscous[i];
        viscous_work_J += viscous[i] * mean;
      }
    }
    damping_loss_J += pass.masses_kg[vertex] * damped;
  }
  pass.viscous_loss_J = -h * viscous_work_J;
  pass.mass_damping_loss_J = h * pass.mass_damping_1_s * damping_loss_J;
}

}  // namespace
}  // namespace fissure
