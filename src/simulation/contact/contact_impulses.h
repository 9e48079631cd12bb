#pragma once

#include <span>
#include <vector>

#include "contact/contact_constraint.h"
#include "contact/step_view.h"

namespace fissure {

/// Contacts as impulses (contact/METHOD.md 6): Gauss-Seidel sweeps like those of EnforcedDisplacement, until
/// a sweep changes nothing, with two differences. Each contact accumulates its push and may take back no more
/// than that, as accumulated impulses in rigid-body solvers, so that contacts that share a triangle end at
/// the least push that holds all. And the displacement is motion: it changes the tissue's momentum by the
/// pushes. Only displacement that undoes overlap from before the step is no motion, so that it accelerates
/// nothing.
///
/// Coulomb friction: in the same sweeps a contact also pushes along the tool's surface, against the slip of
/// the tissue point in the step, by at most `friction` times its push along the normal. The limit is a
/// circular cone, because a tissue point is equally mobile in all directions.
///
/// A tool that is a body (StepView::tool_bodies) takes part with its own mass: every push moves the tissue
/// and, in the opposite direction, the tool; gap and slip are taken at the moved tool, and displacement
/// without motion is so for both. The momentum of tissue and tool together is conserved.
class ContactImpulses {
 public:
  /// `least_mobility`: a contact is ignored where the mobility of its point, over that of its most mobile
  /// vertex, is smaller. Such a point hangs on fixed vertices and could be moved only by throwing that
  /// vertex.
  ContactImpulses(int vertex_count, int sweeps, double least_mobility = 0)
      : sweeps_(sweeps), least_mobility_(least_mobility), motion_m_(vertex_count) {}

  /// Moves the step's positions_m and tool_bodies in place. inverse_masses: [vertex] 1/kg, 0: fixed.
  void apply(std::span<const ContactConstraint> constraints, std::span<const double> inverse_masses,
             const StepView& step);

  /// [vertex] displacement by the last apply() that counts as motion; divided by the time step it is the
  /// change of velocity. Scene frame, as all vectors here.
  std::span<const Vec3> motion_m() const { return motion_m_; }
  std::span<Vec3> motion_m() { return motion_m_; }
  /// [vertex] displacement in the step before the contacts of the last apply().
  std::span<const Vec3> way_m() const { return way_m_; }
  /// Number of contacts with tools that push.
  int pushing() const;
  /// Impulse of all contacts with tools on the tissue, times the time step, kg m. The contribution of each
  /// contact is multiplied by the factor of its first vertex (`factors`: [vertex]).
  Vec3 total(std::span<const double> factors) const;
  /// The same for the contacts of one tool, or of the ground with kGround.
  Vec3 ofTool(int tool, std::span<const double> factors) const;

  /// Work of the tools on the tissue times the square of the time step, kg m2: the sum over contacts of the
  /// impulse, times the time step, times the displacement of the tool point in the step.
  double toolWork_kg_m2() const;

  const DisplacementCounts& counts() const { return counts_; }

 private:
  struct Push {
    int vertex = 0;       ///< first vertex of its triangle
    int tool = 0;         ///< tool index or kGround
    double mobility = 0;  ///< mobility of the tissue point relative to the tool along the normal, 1/kg
    double kg_m = 0;      ///< accumulated impulse times the time step, never negative
    Vec3 tool_step_m = Vec3::Zero();  ///< displacement of the tool point in the step
    double tool_way_m = 0;            ///< the same, along the normal
    double old_overlap_m = 0;  ///< overlap at the start of the step that is not yet taken out of the motion
    Vec3 friction_kg_m = Vec3::Zero();  ///< accumulated friction on the tissue, like kg_m
    /// Position of the tissue point if it stuck to the tool; only with friction.
    Vec3 stuck_at_m = Vec3::Zero();
    double tool_inverse_mass_1_kg = 0;
    Vec3* tool_moved_m = nullptr;  ///< offset, later motion, of a tool that is a body
  };
  void prepare(std::span<const ContactConstraint> constraints, std::span<const double> inverse_masses,
               const StepView& step);
  void pushOut(std::span<const ContactConstraint> constraints, std::span<const double> inverse_masses,
               std::span<Vec3> positions_m);
  void forgetOldOverlap(std::span<const ContactConstraint> constraints,
                        std::span<const double> inverse_masses);
  void beginMotion(const StepView& step);
  static void recoil(const Push& push, const Vec3& push_kg_m);
  static bool rub(const ContactConstraint& contact, Push& push, const Vec3& point_m,
                  std::span<const double> inverse_masses, std::span<Vec3> of_vertices);

  int sweeps_;
  double least_mobility_;
  DisplacementCounts counts_;
  std::vector<Push> pushes_;  ///< one per constraint
  std::vector<Vec3> normals_;
  std::vector<Vec3> start_m_;  ///< positions before the contacts
  std::vector<Vec3> way_m_;    ///< [vertex] displacement in the step before the contacts
  std::vector<Vec3> motion_m_;
};

}  // namespace fissure
