#pragma once

#include <span>
#include <vector>

#include "elastic/elastic_tissue.h"

namespace fissure {

inline constexpr MaterialModel kModels[] = {MaterialModel::neo_hookean, MaterialModel::linear_corotated,
                                            MaterialModel::saint_venant_kirchhoff};

/// Internal forces on the vertices of a tissue without fixed vertices, gravity and mass damping, where it
/// stands: what one substep from no velocity gives them. Leaves positions as they were, and no velocity.
inline std::vector<Vec3> internalForces_N(ElasticTissue& tissue) {
  const std::vector<Vec3> before_m(tissue.positions_m().begin(), tissue.positions_m().end());
  const double substep_s = 1e-3 * tissue.criticalStep_s();
  std::vector<Vec3> forces_N(before_m.size());
  for (Vec3& velocity_m_s : tissue.velocities_m_s()) velocity_m_s.setZero();
  tissue.advance(substep_s);
  for (std::size_t v = 0; v < before_m.size(); ++v) {
    forces_N[v] = tissue.masses_kg()[v] / substep_s * tissue.velocities_m_s()[v];
    tissue.velocities_m_s()[v].setZero();
    tissue.positions_m()[v] = before_m[v];
  }
  return forces_N;
}

/// Mean first Piola-Kirchhoff stress of a mesh that `forces_N` hold in its shape: the virial.
inline Mat3 meanStress_Pa(std::span<const Vec3> rest_m, std::span<const Vec3> forces_N, double volume_m3) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t v = 0; v < rest_m.size(); ++v) sum -= forces_N[v] * rest_m[v].transpose();
  return sum / volume_m3;
}

inline double balance_J(const ElasticEnergies& e) {
  return e.kinetic_J + e.stored_J + e.gravity_J + e.viscous_loss_J + e.mass_damping_loss_J - e.contact_work_J;
}

}  // namespace fissure
