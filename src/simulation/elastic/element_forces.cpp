#include "elastic/element_forces.h"

#include <numeric>

namespace fissure {

namespace {

/// The law of `material` whose lambda is `lambda_Pa`.
ElementLaw lawOf(const ElasticMaterial& material, double lambda_Pa) {
  const double mu_Pa = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio).mu_Pa;
  if (material.model == MaterialModel::linear_corotated)
    return {ElementModel::linear_corotated, mu_Pa, lambda_Pa, 1, material.viscosity_Pa_s};
  const double mu = 4.0 / 3 * mu_Pa, lambda = lambda_Pa + 5.0 / 6 * mu_Pa;
  return {ElementModel::neo_hookean, mu, lambda, 1 + 0.75 * mu / lambda, material.viscosity_Pa_s};
}

}  // namespace

VolumeSplit splitVolume(const ElasticMaterial& material) {
  const LameConstants lame = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio);
  if (material.poissons_ratio <= VolumeSplit::kAveragedAbove) return {lame.lambda_Pa, 0};
  constexpr double kRatio = VolumeSplit::kElementRatio;
  const double elements_Pa = lame.mu_Pa * 2 * kRatio / (1 - 2 * kRatio);
  return {elements_Pa, lame.lambda_Pa - elements_Pa};
}

ElementForces::ElementForces(const TetrahedralMesh& rest, const ElasticMaterial& material, InstructionSet set)
    : lanes_(rest),
      kernels_(&elementKernels(set)),
      lame_(lameConstants(material.youngs_modulus_Pa, material.poissons_ratio)),
      split_(splitVolume(material)),
      law_(lawOf(material, split_.elements_Pa)),
      stretch_law_(lawOf(material, lame_.lambda_Pa)),
      force_slots_(4 * lanes_.slotCount()) {
  if (material.viscosity_Pa_s > 0) viscous_slots_.resize(force_slots_.size());
  if (split_.averaged_Pa > 0) {
    volume_slots_.resize(lanes_.slotCount());
    pressures_Pa_.resize(rest.vertices_m.size());
  }
}

double ElementForces::averagePressures_J(const ElementLaw& law, const double* positions_m) {
  if (split_.averaged_Pa == 0) return 0;
  kernels_->volumeStrains(lanes_.view(), law, positions_m, volume_slots_.data());
  double energy_J = 0;
  for (std::size_t v = 0; v < pressures_Pa_.size(); ++v) {
    double sum_m3 = 0;
    for (int slot = lanes_.first_slots[v]; slot < lanes_.first_slots[v + 1]; ++slot)
      sum_m3 += volume_slots_[slot];
    const double strain = sum_m3 / (4 * lanes_.vertex_volumes_m3[v]);
    pressures_Pa_[v] = split_.averaged_Pa * strain;
    energy_J += 0.5 * pressures_Pa_[v] * strain * lanes_.vertex_volumes_m3[v];
  }
  return energy_J;
}

void ElementForces::compute(const double* positions_m, const double* velocities_m_s) {
  averagePressures_J(law_, positions_m);
  kernels_->forces(lanes_.view(), law_,
                   {.positions_m = positions_m,
                    .velocities_m_s = viscous_slots_.empty() ? nullptr : velocities_m_s,
                    .pressures_Pa = pressures_Pa_.empty() ? nullptr : pressures_Pa_.data(),
                    .forces_N = force_slots_.data(),
                    .viscous_forces_N = viscous_slots_.data()});
}

void ElementForces::computeSmall(const double* displacements_m, double added_shear_Pa) {
  const ElementLaw law = {ElementModel::small_strain, lame_.mu_Pa + added_shear_Pa, split_.elements_Pa};
  averagePressures_J(law, displacements_m);
  kernels_->forces(lanes_.view(), law,
                   {.positions_m = displacements_m,
                    .pressures_Pa = pressures_Pa_.empty() ? nullptr : pressures_Pa_.data(),
                    .forces_N = force_slots_.data()});
}

double ElementForces::storedEnergy_J(const double* positions_m) {
  const double of_vertices_J = averagePressures_J(law_, positions_m);
  double of_lanes_J[kLanes] = {};
  kernels_->storedEnergy(lanes_.view(), law_, positions_m, of_lanes_J);
  return std::accumulate(of_lanes_J, of_lanes_J + kLanes, of_vertices_J);
}

StretchPass ElementForces::stretch(const double* positions_m) const {
  StretchPass pass;
  kernels_->stretch(lanes_.view(), stretch_law_, positions_m, pass);
  return pass;
}

}  // namespace fissure
