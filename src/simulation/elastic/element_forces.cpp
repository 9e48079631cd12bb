#include "elastic/element_forces.h"

#include <numeric>
#include <utility>

namespace fissure {

namespace {

/// The law of `material` whose lambda is `lambda_Pa`.
ElementLaw lawOf(const ElasticMaterial& material, double lambda_Pa) {
  const double mu_Pa = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio).mu_Pa;
  if (material.model == MaterialModel::linear_corotated)
    return {ElementModel::linear_corotated, mu_Pa, lambda_Pa, 1, material.viscosity_Pa_s};
  if (material.model == MaterialModel::saint_venant_kirchhoff)
    return {ElementModel::saint_venant_kirchhoff, mu_Pa, lambda_Pa, 1, material.viscosity_Pa_s};
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

ElementForces::ElementForces(const TetrahedralMesh& rest, const ElementMaterials& materials,
                             InstructionSet set)
    : materials_(distinctMaterials(materials, rest.tetrahedra.size())),
      lanes_(rest, materials_.of_elements),
      kernels_(&elementKernels(set)),
      force_slots_(4 * lanes_.slotCount()) {
  for (const ElasticMaterial& material : materials_.materials) {
    const LameConstants lame = lameConstants(material.youngs_modulus_Pa, material.poissons_ratio);
    const VolumeSplit split = splitVolume(material);
    OfMaterial of = {.law = lawOf(material, split.elements_Pa),
                     .stretch_law = lawOf(material, lame.lambda_Pa),
                     .small_strain = {lame.mu_Pa, split},
                     .pressures_Pa = {}};
    if (material.viscosity_Pa_s > 0) viscous_slots_.resize(force_slots_.size());
    if (split.averaged_Pa > 0) {
      volume_slots_.resize(lanes_.slotCount());
      of.pressures_Pa.resize(rest.vertices_m.size());
    }
    of_materials_.push_back(std::move(of));
  }
}

std::vector<double> ElementForces::vertexMasses_kg() const {
  std::vector<double> masses_kg(lanes_.vertex_volumes_m3.size());
  for (std::size_t m = 0; m < of_materials_.size(); ++m)
    for (const VertexShare& share : lanes_.materials[m].shares)
      masses_kg[share.vertex] += materials_.materials[m].density_kg_m3 * share.volume_m3;
  return masses_kg;
}

std::vector<SmallStrainLaw> ElementForces::smallStrainLaws() const {
  std::vector<SmallStrainLaw> laws;
  for (const OfMaterial& of : of_materials_) laws.push_back(of.small_strain);
  return laws;
}

double ElementForces::averagePressures_J(std::size_t m, const ElementLaw& law, double averaged_Pa,
                                         const double* positions_m) {
  OfMaterial& of = of_materials_[m];
  if (of.pressures_Pa.empty()) return 0;
  const MaterialLanes& lanes = lanes_.materials[m];
  kernels_->volumeStrains(lanes_.viewOf(lanes), law, positions_m, volume_slots_.data());
  double energy_J = 0;
  for (const VertexShare& share : lanes.shares) {
    double sum_m3 = 0;
    for (int slot = share.first_slot; slot < share.end_slot; ++slot) sum_m3 += volume_slots_[slot];
    const double strain = sum_m3 / (4 * share.volume_m3);
    double& pressure_Pa = of.pressures_Pa[share.vertex];
    pressure_Pa = averaged_Pa * strain;
    energy_J += 0.5 * pressure_Pa * strain * share.volume_m3;
  }
  return energy_J;
}

void ElementForces::compute(const double* positions_m, const double* velocities_m_s) {
  for (std::size_t m = 0; m < of_materials_.size(); ++m) {
    const OfMaterial& of = of_materials_[m];
    averagePressures_J(m, of.law, of.small_strain.lambda.averaged_Pa, positions_m);
    kernels_->forces(lanes_.viewOf(lanes_.materials[m]), of.law,
                     {.positions_m = positions_m,
                      .velocities_m_s = of.law.viscosity_Pa_s > 0 ? velocities_m_s : nullptr,
                      .pressures_Pa = of.pressures(),
                      .forces_N = force_slots_.data(),
                      .viscous_forces_N = viscous_slots_.data()});
  }
}

void ElementForces::computeSmall(const double* displacements_m, std::span<const SmallStrainLaw> laws) {
  for (std::size_t m = 0; m < of_materials_.size(); ++m) {
    const ElementLaw law = {ElementModel::small_strain, laws[m].mu_Pa, laws[m].lambda.elements_Pa};
    averagePressures_J(m, law, laws[m].lambda.averaged_Pa, displacements_m);
    kernels_->forces(lanes_.viewOf(lanes_.materials[m]), law,
                     {.positions_m = displacements_m,
                      .pressures_Pa = of_materials_[m].pressures(),
                      .forces_N = force_slots_.data()});
  }
}

double ElementForces::storedEnergy_J(const double* positions_m) {
  double of_vertices_J = 0;
  double of_lanes_J[kLanes] = {};
  for (std::size_t m = 0; m < of_materials_.size(); ++m) {
    const OfMaterial& of = of_materials_[m];
    of_vertices_J += averagePressures_J(m, of.law, of.small_strain.lambda.averaged_Pa, positions_m);
    kernels_->storedEnergy(lanes_.viewOf(lanes_.materials[m]), of.law, positions_m, of_lanes_J);
  }
  return std::accumulate(of_lanes_J, of_lanes_J + kLanes, of_vertices_J);
}

void ElementForces::stretch(const double* positions_m, std::span<StretchPass> passes) const {
  for (std::size_t m = 0; m < of_materials_.size(); ++m)
    kernels_->stretch(lanes_.viewOf(lanes_.materials[m]), of_materials_[m].stretch_law, positions_m,
                      passes[m]);
}

}  // namespace fissure
