#pragma once

#include <memory>
#include <span>

#include "base/geometry.h"
#include "base/tetrahedra.h"
#include "elastic/material.h"

namespace fissure {

/// Energies of a tissue, joules. What is kinetic, stored and gravity's is of now; losses and work are sums
/// since the start. kinetic + stored + gravity + losses - contact work stays what it was after the first
/// substep. Positions and velocities of symplectic Euler are half a substep apart, so stored and gravity's
/// are taken at the positions half a substep back, where the velocities belong: with these the balance closes
/// to the second order. A change of the substep costs an error of the first order, once: half the change
/// times the power of the internal forces.
struct ElasticEnergies {
  double kinetic_J = 0;
  double stored_J = 0;   ///< elastic; 0 at rest
  double gravity_J = 0;  ///< potential in the field of gravity; 0 at rest
  double viscous_loss_J = 0;
  double mass_damping_loss_J = 0;
  double contact_work_J = 0;  ///< done on the tissue
};

/// A tissue of linear tetrahedra with lumped masses, moved by symplectic Euler in substeps (total Lagrangian
/// explicit dynamics, Miller, Joldes, Lance, Wittek 2007; METHOD section 10). Results are the same bits on
/// every instruction set. Poisson's ratios above 0.45 get part of their pressure from nodal averages of the
/// volume ratio, against locking (VolumeSplit). Nothing allocates after the construction. One object belongs
/// to one thread: const functions use its scratch arrays too.
class ElasticTissue {
 public:
  /// `surface_vertices`: how many vertices of `rest`, its first, contacts may move. Fixed vertices never
  /// move. Throws std::invalid_argument, with one line, where the material, an index or the volume of a
  /// tetrahedron is not valid, or FISSURE_INSTRUCTIONS names no instruction set of this machine.
  ElasticTissue(const TetrahedralMesh& rest, const ElementMaterials& materials,
                std::span<const int> fixed_vertices, int surface_vertices, const Vec3& gravity_m_s2);
  /// All of one material.
  ElasticTissue(const TetrahedralMesh& rest, const ElasticMaterial& material,
                std::span<const int> fixed_vertices, int surface_vertices, const Vec3& gravity_m_s2);
  ~ElasticTissue();
  ElasticTissue(ElasticTissue&&) noexcept;
  ElasticTissue& operator=(ElasticTissue&&) noexcept;

  /// Largest stable substep, seconds: that of the rest shape, shortened by how much the most stretched
  /// element of each material has stiffened, as the last substepsFor() found it.
  double criticalStep_s() const;
  /// The largest stable substep at rest if only the elements of this material had a stiffness and a
  /// viscosity.
  double criticalStepOf_s(const ElasticMaterial& material) const;

  /// How many equal substeps a step of `step_s` needs now: each at most kStepSafety of the largest stable
  /// one, which is looked for in the present shape, and is foreseen to shrink as much again as it did since
  /// the last call. It never falls while step_s stays the same: each change costs an error of the energy
  /// balance, since velocities are half a substep behind positions, and tissue that vibrates would make many.
  /// Called once a step. At least 1, at most kMostSubsteps.
  int substepsFor(double step_s);

  /// One substep: forces, velocities, positions.
  void advance(double substep_s);

  /// Contacts displaced the surface vertices by `motion_m` (positions have changed in place already): adds
  /// motion over substep to their velocities, and books the contacts' work on the path of the substep. Comes
  /// after the advance() whose result it corrects, with the same substep; fixed vertices are left out.
  void addMotion(std::span<const Vec3> motion_m, double substep_s);

  /// One per vertex, the surface's first. What a caller changes here without addMotion is in no balance.
  std::span<Vec3> positions_m();
  std::span<const Vec3> positions_m() const;
  std::span<Vec3> velocities_m_s();
  std::span<const Vec3> velocities_m_s() const;
  std::span<const double> masses_kg() const;
  std::span<const double> inverseMasses_1_kg() const;  ///< 0 for fixed vertices
  int surfaceVertices() const;

  ElasticEnergies energies() const;
  int invertedElements() const;  ///< elements of no or negative volume now
  bool finite() const;           ///< whether all positions and velocities are finite numbers

  static constexpr double kStepSafety = 0.9;   ///< largest substep taken, over the largest stable one
  static constexpr int kMostSubsteps = 10000;  ///< of a step; more would be a tissue that flies apart

 private:
  struct Arrays;
  std::unique_ptr<Arrays> arrays_;
};

}  // namespace fissure
