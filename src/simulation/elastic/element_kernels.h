#pragma once

// This header is included by sources that are compiled for other instruction sets than the rest of the
// program. Neither it nor its includes may have inline functions, because the linker could give the whole
// program a copy that does not run on every machine.

namespace fissure {

/// Number of elements in a group; each has one lane in vectors of doubles.
inline constexpr int kLanes = 8;

/// Tetrahedra in groups of lanes. The values of each corner are written into a slot of its own; the slots of
/// a vertex are contiguous, so that their sum has a fixed order.
struct ElementArrays {
  int groups = 0;
  int vertices = 0;
  const int* corners = nullptr;  ///< [group][4 corners][lane]: vertex of the corner
  const int* slots = nullptr;    ///< [group][4 corners][lane]: slot of the corner
  /// [group][9][lane]: inverse of the matrix whose columns are the rest edges from the fourth corner.
  const double* inverse_edges = nullptr;
  /// [group][7][lane]: inverse edges times their transpose (00, 01, 02, 11, 12, 22), and their determinant.
  const double* metrics = nullptr;
  const double* volumes_m3 = nullptr;  ///< [group][lane], at rest; 0 for lanes that fill up a last group
  const int* first_slots = nullptr;    ///< [vertices + 1]: first slot of each vertex
};

enum class ElementModel { neo_hookean, linear_corotated, saint_venant_kirchhoff, small_strain };

/// Coefficients of the stress (material.h): mu', lambda' and alpha of the neo-Hookean law, mu and lambda of
/// the others.
struct ElementLaw {
  ElementModel model = ElementModel::neo_hookean;
  double mu_Pa = 0;
  double lambda_Pa = 0;
  double alpha = 1;
  double viscosity_Pa_s = 0;
};

/// Inputs and outputs of the pass that computes forces.
struct ForcePass {
  /// [vertex][3] (small_strain: displacements); one more double is read.
  const double* positions_m = nullptr;
  const double* velocities_m_s = nullptr;  ///< like positions; null: no viscosity
  const double* pressures_Pa = nullptr;    ///< [vertex]: nodal averages; null: none
  double* forces_N = nullptr;  ///< [slot][4]: elastic force on the corner; the fourth number has no meaning
  double* viscous_forces_N = nullptr;  ///< like forces_N
};

/// Inputs and outputs of the pass that moves the vertices.
struct MovePass {
  const double* forces_N = nullptr;          ///< from ForcePass
  const double* viscous_forces_N = nullptr;  ///< from ForcePass; null: no viscosity
  const double* masses_kg = nullptr;
  const double* inverse_masses_1_kg = nullptr;
  double gravity_m_s2[3] = {0, 0, 0};
  double mass_damping_1_s = 0;
  double substep_s = 0;
  double* positions_m = nullptr;
  double* velocities_m_s = nullptr;
  double* accelerations_m_s2 = nullptr;  ///< [vertex][3]: of this substep
  double* viscous_sums_N = nullptr;  ///< [vertex][3]: viscous force of this substep, where there is viscosity
  double viscous_loss_J = 0;         ///< of this substep
  double mass_damping_loss_J = 0;    ///< of this substep
};

/// Largest growth of stiffness and damping since rest (critical_step.h), per lane.
struct StretchPass {
  double stiffness_growth[kLanes] = {};
  double viscous_growth[kLanes] = {};
  double inverted[kLanes] = {};  ///< number of inverted elements
};

/// The passes over all elements or vertices. Each gives the same bits on all instruction sets.
struct ElementKernels {
  void (*forces)(const ElementArrays&, const ElementLaw&, const ForcePass&);
  /// Writes, for each corner, the rest volume times the volume strain of its element into its slot: J - 1, or
  /// tr(R^T F) - 3, or the trace of the Green strain or of the small strain.
  void (*volumeStrains)(const ElementArrays&, const ElementLaw&, const double* positions_m, double* slots);
  void (*move)(const ElementArrays&, MovePass&);
  /// Adds the elastic energy of each lane's elements, without that of nodal averages, to `energies_J[lane]`.
  void (*storedEnergy)(const ElementArrays&, const ElementLaw&, const double* positions_m,
                       double* energies_J);
  void (*stretch)(const ElementArrays&, const ElementLaw&, const double* positions_m, StretchPass&);
};

extern const ElementKernels kBaselineKernels;
#ifdef __x86_64__
extern const ElementKernels kAvx2Kernels;
extern const ElementKernels kAvx512Kernels;
#endif

}  // namespace fissure
