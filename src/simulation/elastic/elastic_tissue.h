#pragma once

#include <memory>
#include <span>

#include "base/geometry.h"
#include "base/tetrahedra.h"
#include "elastic/material.h"

namespace fissure {

/// Energies of a tissue, joules (elastic/METHOD.md 8): present kinetic, stored and gravity's energy, and
/// losses and work summed since the start. kinetic + stored + gravity + losses - contact work is constant
/// after the first substep. Positions and velocities of symplectic Euler are half a substep apart, so stored
/// and gravity's energy are taken at the positions half a substep back, where the velocities belong; with
/// these the balance closes to the second order. Each change of the substep costs an error of the first
/// order: half the change times the power of the internal forces.
struct ElasticEnergies {
  double kinetic_J = 0;
  double stored_J = 0;   ///< elastic energy; 0 at rest
  double gravity_J = 0;  ///< potential energy of gravity; 0 at rest
  double viscous_loss_J = 0;
  double mass_damping_loss_J = 0;
  double contact_work_J = 0;  ///< done on the tissue
};

/// A tissue of linear tetrahedra with lumped masses, moved by symplectic Euler in substeps (total Lagrangian
/// explicit dynamics, Miller, Joldes, Lance, Wittek 2007; elastic/METHOD.md 1). All vectors are in the scene
/// frame. Results are the same bits on every instruction set. For Poisson's ratios above 0.45 part of the
/// pressure comes from nodal averages, against locking (VolumeSplit). Nothing is allocated after
/// construction. One object belongs to one thread: const functions use scratch arrays too.
class ElasticTissue {
 public:
  /// `surface_vertices`: number of vertices of `rest`, the first ones, that contacts may move.
  /// `fixed_vertices`: indices of vertices that never move. Throws std::invalid_argument, with one line,
  /// where the material, an index or the volume of a tetrahedron is not valid, or FISSURE_INSTRUCTIONS names
  /// no instruction set of this machine.
  ElasticTissue(const TetrahedralMesh& rest, const ElementMaterials& materials,
                std::span<const int> fixed_vertices, int surface_vertices, const Vec3& gravity_m_s2);
  /// The same for a single material.
  ElasticTissue(const TetrahedralMesh& rest, const ElasticMaterial& material,
                std::span<const int> fixed_vertices, int surface_vertices, const Vec3& gravity_m_s2);
  ~ElasticTissue();
  ElasticTissue(ElasticTissue&&) noexcept;
  ElasticTissue& operator=(ElasticTissue&&) noexcept;

  /// Largest stable substep, seconds: that of the rest shape, shortened for the stiffening of the most
  /// stretched element of each material at the last substepsFor().
  double criticalStep_s() const;
  /// Largest stable substep at rest, seconds, if only the elements of this material had a stiffness and a
  /// viscosity.
  double criticalStepOf_s(const ElasticMaterial& material) const;

  /// Number of equal substeps for a step of `step_s`, 1 to kMostSubsteps (elastic/METHOD.md 6); to be called
  /// once per step. Each substep is at most kStepSafety times the largest stable one, which is computed for
  /// the present shape and assumed to shrink by as much again as since the last call. The number never falls
  /// while step_s stays the same, because each change costs an error of the energy balance, and tissue that
  /// vibrates would cause many.
  int substepsFor(double step_s);
  /// To be called between two calls of substepsFor() when tools move `factor` times as fast from here on.
  /// Where they become slower, the number of substeps falls to that from before they last became faster; it
  /// falls in no other case.
  void changeTempo(double factor);

  /// One substep of length `substep_s`: forces, then velocities, then positions.
  void advance(double substep_s);

  /// Adds the motion by which contacts have displaced the surface vertices ([surface vertex]; the positions
  /// have been changed in place already): motion over substep is added to the velocities, and the contacts'
  /// work on the path of the substep is counted. To be called after the advance() whose result the contacts
  /// corrected, with the same substep; fixed vertices are ignored.
  void addMotion(std::span<const Vec3> motion_m, double substep_s);

  /// [vertex] arrays, those of the surface first. Changes by a caller without addMotion() are missing in the
  /// energy balance.
  std::span<Vec3> positions_m();
  std::span<const Vec3> positions_m() const;
  std::span<Vec3> velocities_m_s();
  std::span<const Vec3> velocities_m_s() const;
  std::span<const double> masses_kg() const;
  std::span<const double> inverseMasses_1_kg() const;  ///< [vertex] 0: fixed
  int surfaceVertices() const;

  ElasticEnergies energies() const;
  int invertedElements() const;  ///< number of elements whose volume is now zero or negative
  bool finite() const;           ///< whether all positions and velocities are finite numbers

  static constexpr double kStepSafety = 0.9;   ///< largest substep taken, over the largest stable one
  static constexpr int kMostSubsteps = 10000;  ///< limit for one step; tissue that needs more flies apart

 private:
  struct Arrays;
  std::unique_ptr<Arrays> arrays_;
};

}  // namespace fissure
