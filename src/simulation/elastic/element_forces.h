#pragma once

#include <span>
#include <vector>

#include "base/tetrahedra.h"
#include "elastic/element_lanes.h"
#include "elastic/instruction_set.h"
#include "elastic/material.h"

namespace fissure {

/// How the resistance to a change of volume is shared between elements and vertices. Linear tetrahedra of
/// nearly incompressible tissue lock: each has to keep its volume, and nearly no motion is left. Above a
/// Poisson's ratio of kAveragedAbove, elements keep only the lambda of kElementRatio, and the rest resists
/// the volume strain averaged at the vertices by volume (average nodal pressure: Bonet, Burton 1998; Joldes,
/// Wittek, Miller 2009). Its energy is that of the vertices, so forces stay its exact derivative, and where
/// all of a mesh deforms alike nothing changes. Where materials meet, a vertex has an average of each: strain
/// jumps there, and so may pressure. It takes a second pass over the elements. It takes away most
/// of what locking adds in bending and compression (tests/simulation/elastic/locking_test.cpp has numbers),
/// but not the stiffness that linear tetrahedra have in bending at any Poisson's ratio; and it does not
/// control the pressure of each element, which may alternate between neighbours.
struct VolumeSplit {
  static constexpr double kAveragedAbove = 0.45;
  static constexpr double kElementRatio = 0.3;
  double elements_Pa = 0;  ///< lambda of the elements
  double averaged_Pa = 0;  ///< lambda of the vertices; 0: none
};

VolumeSplit splitVolume(const ElasticMaterial& material);

/// Hooke's law of small strains, as the elements and the vertices of one material have it.
struct SmallStrainLaw {
  double mu_Pa = 0;
  VolumeSplit lambda;
};

/// Internal forces of a mesh, and what else is a sum over its elements. Arrays of vertices hold three doubles
/// each, and one more double at the end that is read but has no meaning.
class ElementForces {
 public:
  /// Throws std::invalid_argument as ElementLanes and distinctMaterials() do.
  ElementForces(const TetrahedralMesh& rest, const ElementMaterials& materials, InstructionSet set);

  ElementArrays arrays() const { return lanes_.view(); }
  const ElementKernels& kernels() const { return *kernels_; }
  const std::vector<double>& vertexVolumes_m3() const { return lanes_.vertex_volumes_m3; }
  std::vector<double> vertexMasses_kg() const;
  /// Each once; what follows that is "one a material" is in their order.
  const std::vector<ElasticMaterial>& materials() const { return materials_.materials; }
  std::vector<SmallStrainLaw> smallStrainLaws() const;

  /// Forces on corners, left in forceSlots() and, where a material has a viscosity, viscousSlots().
  void compute(const double* positions_m, const double* velocities_m_s);
  /// Forces of the small displacements `displacements_m` from rest, left in forceSlots(), if the materials
  /// had these laws, one a material, of which only those with an averaged lambda may have one.
  void computeSmall(const double* displacements_m, std::span<const SmallStrainLaw> laws);
  const double* forceSlots() const { return force_slots_.data(); }
  const double* viscousSlots() const { return viscous_slots_.empty() ? nullptr : viscous_slots_.data(); }

  double storedEnergy_J(const double* positions_m);
  /// Raises `passes`, one a material, to what its elements have.
  void stretch(const double* positions_m, std::span<StretchPass> passes) const;

 private:
  /// What passes over the elements of one material need.
  struct OfMaterial {
    ElementLaw law, stretch_law;
    SmallStrainLaw small_strain;
    std::vector<double> pressures_Pa;  ///< one a vertex; empty: nothing is averaged

    const double* pressures() const { return pressures_Pa.empty() ? nullptr : pressures_Pa.data(); }
  };

  /// Nodal averages of the volume strain of material number `m` become pressures; their energy.
  double averagePressures_J(std::size_t m, const ElementLaw& law, double averaged_Pa,
                            const double* positions_m);

  ElementMaterials materials_;
  ElementLanes lanes_;
  const ElementKernels* kernels_;
  std::vector<OfMaterial> of_materials_;
  std::vector<double> force_slots_, viscous_slots_, volume_slots_;
};

}  // namespace fissure
