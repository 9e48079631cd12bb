#pragma once

#include <span>
#include <vector>

#include "base/tetrahedra.h"
#include "elastic/element_lanes.h"
#include "elastic/instruction_set.h"
#include "elastic/material.h"

namespace fissure {

/// The split of the Lame constant lambda, the resistance to a change of volume, between elements and vertices
/// (elastic/METHOD.md 3). Linear tetrahedra of nearly incompressible tissue lock, because each has to keep
/// its volume. Above a Poisson's ratio of kAveragedAbove, elements keep only the lambda that belongs to
/// kElementRatio; the rest resists the volume strain averaged at the vertices, weighted by volume (average
/// nodal pressure: Bonet, Burton 1998; Joldes, Wittek, Miller 2009). Forces are the exact derivative of the
/// energy, and homogeneous deformation is unaffected. A vertex at which materials meet has one average per
/// material, because strain and pressure may jump there. A second pass over the elements is needed. The split
/// removes most of the stiffness that locking adds in bending and compression (numbers:
/// tests/simulation/elastic/locking_test.cpp), but not the bending stiffness that linear tetrahedra have at
/// any Poisson's ratio, and single elements' pressures may still alternate between neighbours.
struct VolumeSplit {
  static constexpr double kAveragedAbove = 0.45;
  static constexpr double kElementRatio = 0.3;
  double elements_Pa = 0;  ///< lambda of the elements
  double averaged_Pa = 0;  ///< lambda of the vertices; 0: none
};

/// The split for a material.
VolumeSplit splitVolume(const ElasticMaterial& material);

/// Hooke's law of small strains for one material, with lambda split between elements and vertices.
struct SmallStrainLaw {
  double mu_Pa = 0;
  VolumeSplit lambda;
};

/// Internal forces and other sums over the elements of a mesh. Input arrays hold three doubles per vertex, in
/// the scene frame, and one more double at the end that is read but not used.
class ElementForces {
 public:
  /// Throws std::invalid_argument as ElementLanes and distinctMaterials() do.
  ElementForces(const TetrahedralMesh& rest, const ElementMaterials& materials, InstructionSet set);

  ElementArrays arrays() const { return lanes_.view(); }
  const ElementKernels& kernels() const { return *kernels_; }
  const std::vector<double>& vertexVolumes_m3() const { return lanes_.vertex_volumes_m3; }
  /// [vertex] lumped masses: a quarter of the mass of each element.
  std::vector<double> vertexMasses_kg() const;
  /// The distinct materials, in the order of all "one per material" arrays below.
  const std::vector<ElasticMaterial>& materials() const { return materials_.materials; }
  std::vector<SmallStrainLaw> smallStrainLaws() const;

  /// Computes the forces on corners, in newtons, into forceSlots() and, where a material has a viscosity,
  /// viscousSlots().
  void compute(const double* positions_m, const double* velocities_m_s);
  /// Computes into forceSlots() the linear forces for small displacements from rest with the given laws, one
  /// per material. Only materials that have an averaged lambda may get one here.
  void computeSmall(const double* displacements_m, std::span<const SmallStrainLaw> laws);
  const double* forceSlots() const { return force_slots_.data(); }
  const double* viscousSlots() const { return viscous_slots_.empty() ? nullptr : viscous_slots_.data(); }

  /// Elastic energy at these positions, nodal averages included; 0 at rest.
  double storedEnergy_J(const double* positions_m);
  /// Raises the growths in `passes`, one per material, to the largest of its elements, and counts inverted
  /// elements.
  void stretch(const double* positions_m, std::span<StretchPass> passes) const;

 private:
  /// Data of one material for passes over its elements.
  struct OfMaterial {
    ElementLaw law, stretch_law;
    SmallStrainLaw small_strain;
    std::vector<double> pressures_Pa;  ///< [vertex] averaged pressure; empty: nothing is averaged

    const double* pressures() const { return pressures_Pa.empty() ? nullptr : pressures_Pa.data(); }
  };

  /// Computes the nodal pressures of material number `m` from averages of its volume strain; returns their
  /// energy.
  double averagePressures_J(std::size_t m, const ElementLaw& law, double averaged_Pa,
                            const double* positions_m);

  ElementMaterials materials_;
  ElementLanes lanes_;
  const ElementKernels* kernels_;
  std::vector<OfMaterial> of_materials_;
  std::vector<double> force_slots_, viscous_slots_, volume_slots_;
};

}  // namespace fissure
