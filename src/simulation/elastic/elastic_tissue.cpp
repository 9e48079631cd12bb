#include "elastic/elastic_tissue.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "elastic/critical_step.h"
#include "elastic/element_forces.h"

namespace fissure {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

/// One vector per vertex, and one more that passes read but that has no meaning.
using NodalVectors = std::vector<Vec3>;

NodalVectors zeros(std::size_t vertices) {
  return NodalVectors(vertices + 1, Vec3::Zero());
}

NodalVectors padded(const std::vector<Vec3>& vectors) {
  NodalVectors field = zeros(vectors.size());
  std::copy(vectors.begin(), vectors.end(), field.begin());
  return field;
}

double largestOf(const double (&lanes)[kLanes]) {
  return *std::max_element(lanes, lanes + kLanes);
}

std::vector<double> invertedUnlessFixed(const std::vector<double>& masses_kg,
                                        std::span<const int> fixed_vertices) {
  std::vector<double> inverse;
  for (const double mass_kg : masses_kg) inverse.push_back(1 / mass_kg);
  for (const int vertex : fixed_vertices) {
    if (vertex < 0 || vertex >= static_cast<int>(inverse.size()))
      throw std::invalid_argument(
          fmt::format("elastic tissue: fixed vertex {} is none of its {}", vertex, inverse.size()));
    inverse[vertex] = 0;
  }
  return inverse;
}

}  // namespace

struct ElasticTissue::Arrays {
  Arrays(const TetrahedralMesh& mesh, const ElementMaterials& materials, std::span<const int> fixed)
      : forces(mesh, materials, chosenInstructionSet()),
        mass_damping_1_s(forces.materials()[0].mass_damping_1_s),
        rest_m(mesh.vertices_m),
        positions_m(padded(mesh.vertices_m)),
        velocities_m_s(zeros(rest_m.size())),
        accelerations_m_s2(zeros(rest_m.size())),
        middle_m(zeros(rest_m.size())),
        masses_kg(forces.vertexMasses_kg()),
        inverse_masses_1_kg(invertedUnlessFixed(masses_kg, fixed)),
        critical(forces, inverse_masses_1_kg),
        stretches(forces.materials().size()),
        growths(stretches.size()),
        foreseen(stretches.size()) {
    if (forces.viscousSlots() != nullptr) viscous_N = zeros(rest_m.size());
  }

  std::size_t vertices() const { return rest_m.size(); }

  void findStretches() {
    std::fill(stretches.begin(), stretches.end(), StretchPass{});
    forces.stretch(positions_m.front().data(), stretches);
  }

  ElementForces forces;
  double mass_damping_1_s = 0;
  std::vector<Vec3> rest_m;
  NodalVectors positions_m, velocities_m_s, accelerations_m_s2, viscous_N;
  NodalVectors middle_m;  ///< scratch of energies()
  std::vector<double> masses_kg, inverse_masses_1_kg;
  CriticalStep critical;
  std::size_t surface_vertices = 0;
  Vec3 gravity_m_s2 = Vec3::Zero();
  std::vector<StretchPass> stretches;  ///< one per material: scratch
  std::vector<Growth> growths;         ///< one per material, as the last substepsFor() found them
  std::vector<Growth> foreseen;        ///< scratch of substepsFor()
  double step_s = 0;                   ///< of the last substepsFor()
  int substeps = 0;                    ///< that it gave
  bool changed_tempo = false;          ///< since it: then nothing is foreseen from before
  int substeps_when_slow = 0;          ///< the same at the last changeTempo() to a faster one
  double substep_s = 0;                ///< of the last advance()
  double viscous_loss_J = 0, mass_damping_loss_J = 0, contact_work_J = 0;
};

ElasticTissue::ElasticTissue(const TetrahedralMesh& rest, const ElasticMaterial& material,
                             std::span<const int> fixed_vertices, int surface_vertices,
                             const Vec3& gravity_m_s2)
    : ElasticTissue(rest, ElementMaterials{{material}, {}}, fixed_vertices, surface_vertices, gravity_m_s2) {}

ElasticTissue::ElasticTissue(const TetrahedralMesh& rest, const ElementMaterials& materials,
                             std::span<const int> fixed_vertices, int surface_vertices,
                             const Vec3& gravity_m_s2)
    : arrays_(std::make_unique<Arrays>(rest, materials, fixed_vertices)) {
  if (surface_vertices < 0 || surface_vertices > static_cast<int>(rest.vertices_m.size()))
    throw std::invalid_argument(
        fmt::format("elastic tissue: {} surface vertices of {}", surface_vertices, rest.vertices_m.size()));
  arrays_->surface_vertices = static_cast<std::size_t>(surface_vertices);
  arrays_->gravity_m_s2 = gravity_m_s2;
}

ElasticTissue::~ElasticTissue() = default;
ElasticTissue::ElasticTissue(ElasticTissue&&) noexcept = default;
ElasticTissue& ElasticTissue::operator=(ElasticTissue&&) noexcept = default;

double ElasticTissue::criticalStep_s() const {
  return arrays_->critical.step_s(arrays_->growths);
}

double ElasticTissue::criticalStepOf_s(const ElasticMaterial& material) const {
  const std::vector<ElasticMaterial>& materials = arrays_->forces.materials();
  const auto found = std::find(materials.begin(), materials.end(), material);
  if (found == materials.end()) throw std::invalid_argument("elastic tissue: no element has this material");
  return criticalStepAlone_s(arrays_->forces, arrays_->inverse_masses_1_kg,
                             static_cast<std::size_t>(found - materials.begin()));
}

int ElasticTissue::substepsFor(double step_s) {
  Arrays& a = *arrays_;
  a.findStretches();
  for (std::size_t m = 0; m < a.growths.size(); ++m) {
    const Growth now = {std::max(1.0, largestOf(a.stretches[m].stiffness_growth)),
                        std::max(1.0, largestOf(a.stretches[m].viscous_growth))};
    const Growth& before = a.changed_tempo ? now : a.growths[m];
    a.foreseen[m] = {now.stiffness * std::max(1.0, now.stiffness / before.stiffness),
                     now.viscous * std::max(1.0, now.viscous / before.viscous)};
    a.growths[m] = now;
  }
  a.changed_tempo = false;
  const double wanted = step_s / (kStepSafety * a.critical.step_s(a.foreseen));
  if (step_s != a.step_s) a.substeps = 1;
  const int whole = wanted < kMostSubsteps ? static_cast<int>(std::ceil(wanted)) : kMostSubsteps;
  a.substeps = std::max(a.substeps, whole);
  a.step_s = step_s;
  return a.substeps;
}

void ElasticTissue::changeTempo(double factor) {
  if (factor == 1) return;
  Arrays& a = *arrays_;
  if (factor > 1) a.substeps_when_slow = a.substeps;
  if (factor < 1) a.substeps = a.substeps_when_slow;
  a.changed_tempo = true;
}

void ElasticTissue::advance(double substep_s) {
  Arrays& a = *arrays_;
  a.forces.compute(a.positions_m.front().data(), a.velocities_m_s.front().data());
  MovePass move = {.forces_N = a.forces.forceSlots(),
                   .viscous_forces_N = a.forces.viscousSlots(),
                   .masses_kg = a.masses_kg.data(),
                   .inverse_masses_1_kg = a.inverse_masses_1_kg.data(),
                   .gravity_m_s2 = {a.gravity_m_s2.x(), a.gravity_m_s2.y(), a.gravity_m_s2.z()},
                   .mass_damping_1_s = a.mass_damping_1_s,
                   .substep_s = substep_s,
                   .positions_m = a.positions_m.front().data(),
                   .velocities_m_s = a.velocities_m_s.front().data(),
                   .accelerations_m_s2 = a.accelerations_m_s2.front().data(),
                   .viscous_sums_N = a.viscous_N.empty() ? nullptr : a.viscous_N.front().data()};
  a.forces.kernels().move(a.forces.arrays(), move);
  a.viscous_loss_J += move.viscous_loss_J;
  a.mass_damping_loss_J += move.mass_damping_loss_J;
  a.substep_s = substep_s;
}

void ElasticTissue::addMotion(std::span<const Vec3> motion_m, double substep_s) {
  Arrays& a = *arrays_;
  if (motion_m.size() > a.surface_vertices)
    throw std::invalid_argument(
        fmt::format("elastic tissue: motion of {} vertices, of {}", motion_m.size(), a.surface_vertices));
  for (std::size_t v = 0; v < motion_m.size(); ++v) {
    if (a.inverse_masses_1_kg[v] == 0 || motion_m[v].isZero(0)) continue;
    const Vec3 change_m_s = motion_m[v] / substep_s;
    // All forces of the substep act on the mean of its first and last velocity, which the contact changes.
    const Vec3 first_m_s = a.velocities_m_s[v] - substep_s * a.accelerations_m_s2[v];
    a.velocities_m_s[v] += change_m_s;
    const Vec3 mean_m_s = 0.5 * (first_m_s + a.velocities_m_s[v]);
    a.contact_work_J += a.masses_kg[v] * change_m_s.dot(mean_m_s);
    a.mass_damping_loss_J += 0.5 * a.masses_kg[v] * a.mass_damping_1_s * motion_m[v].dot(first_m_s);
    if (!a.viscous_N.empty()) a.viscous_loss_J -= 0.5 * motion_m[v].dot(a.viscous_N[v]);
  }
}

std::span<Vec3> ElasticTissue::positions_m() {
  return {arrays_->positions_m.data(), arrays_->vertices()};
}
std::span<const Vec3> ElasticTissue::positions_m() const {
  return {arrays_->positions_m.data(), arrays_->vertices()};
}
std::span<Vec3> ElasticTissue::velocities_m_s() {
  return {arrays_->velocities_m_s.data(), arrays_->vertices()};
}
std::span<const Vec3> ElasticTissue::velocities_m_s() const {
  return {arrays_->velocities_m_s.data(), arrays_->vertices()};
}
std::span<const double> ElasticTissue::masses_kg() const {
  return arrays_->masses_kg;
}
std::span<const double> ElasticTissue::inverseMasses_1_kg() const {
  return arrays_->inverse_masses_1_kg;
}
int ElasticTissue::surfaceVertices() const {
  return static_cast<int>(arrays_->surface_vertices);
}

ElasticEnergies ElasticTissue::energies() const {
  Arrays& a = *arrays_;
  ElasticEnergies energies;
  for (std::size_t v = 0; v < a.vertices(); ++v) {
    a.middle_m[v] = a.positions_m[v] - 0.5 * a.substep_s * a.velocities_m_s[v];
    if (a.inverse_masses_1_kg[v] == 0) continue;
    energies.kinetic_J += 0.5 * a.masses_kg[v] * a.velocities_m_s[v].squaredNorm();
    energies.gravity_J -= a.masses_kg[v] * a.gravity_m_s2.dot(a.middle_m[v] - a.rest_m[v]);
  }
  energies.stored_J = a.forces.storedEnergy_J(a.middle_m.front().data());
  energies.viscous_loss_J = a.viscous_loss_J;
  energies.mass_damping_loss_J = a.mass_damping_loss_J;
  energies.contact_work_J = a.contact_work_J;
  return energies;
}

int ElasticTissue::invertedElements() const {
  arrays_->findStretches();
  double inverted = 0;
  for (const StretchPass& stretch : arrays_->stretches)
    for (const double of_lane : stretch.inverted) inverted += of_lane;
  return static_cast<int>(inverted);
}

bool ElasticTissue::finite() const {
  const auto allFinite = [](std::span<const Vec3> vectors) {
    return std::all_of(vectors.begin(), vectors.end(), [](const Vec3& vector) { return vector.allFinite(); });
  };
  return allFinite(positions_m()) && allFinite(velocities_m_s());
}

}  // namespace fissure
