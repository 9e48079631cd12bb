#pragma once

#include <span>
#include <vector>

#include "contact/contact_constraint.h"
#include "contact/step_view.h"

namespace fissure {

/// Contacts as impulses (METHOD section 5, response momentum): Gauss-Seidel sweeps as EnforcedDisplacement's,
/// until one changes nothing, but each contact remembers its push and may take back no more than that, so
/// that contacts that share a triangle end at the least push that holds all (as accumulated impulses do in
/// rigid-body solvers); and the displacement is motion, so the tissue's momentum changes by what its contacts
/// pushed. What only undoes overlap that was there when the step began is displacement without motion, so
/// that it throws nothing out.
///
/// Coulomb friction: within the same sweeps a contact also pushes along the tool's surface, against what the
/// tissue point slips on it in the step, by at most `friction` times its push along the normal: a cone, as a
/// tissue point is as mobile in every direction.
///
/// A tool that is a body (StepView::tool_bodies) takes part with its own mass: every push moves tissue one
/// way and the tool the other, gap and slip are those of the moved tool, and what is displacement without
/// motion is so for both. So the momentum of tissue and tool together stays what it was.
class ContactImpulses {
 public:
  /// `least_mobility`: a contact whose point is less mobile than this share of its most mobile vertex is
  /// none. It could move the point, which hangs on fixed vertices, only by throwing that vertex.
  ContactImpulses(int vertex_count, int sweeps, double least_mobility = 0)
      : sweeps_(sweeps), least_mobility_(least_mobility), motion_m_(vertex_count) {}

  /// Moves the step's positions_m and tool_bodies in place. inverse_masses: one per vertex in 1/kg, 0: fixed.
  void apply(std::span<const ContactConstraint> constraints, std::span<const double> inverse_masses,
             const StepView& step);

  /// Of the last apply, for each vertex: its displacement as far as it is motion; over the time step, the
  /// change of its velocity.
  std::span<const Vec3> motion_m() const { return motion_m_; }
  std::span<Vec3> motion_m() { return motion_m_; }
  /// The way of each vertex in the step before its contacts.
  std::span<const Vec3> way_m() const { return way_m_; }
  /// How many contacts with tools push.
  int pushing() const;
  /// Impulse of all contacts with tools on the tissue, times the time step: kg m; each contact's times the
  /// factor of its first vertex.
  Vec3 total(std::span<const double> factors) const;
  /// The same of one tool's contacts, or with kGround of the ground's.
  Vec3 ofTool(int tool, std::span<const double> factors) const;

  /// Work of the tools on the tissue, times the square of the time step: each contact's impulse times the
  /// displacement of its tool point in the step, kg m2.
  double toolWork_kg_m2() const;

  const DisplacementCounts& counts() const { return counts_; }

 private:
  struct Push {
    int vertex = 0;                   ///< the first of its triangle
    int tool = 0;                     ///< or kGround
    double mobility = 0;              ///< of the tissue point from the tool along the normal, 1/kg
    double kg_m = 0;                  ///< impulse so far times the time step, never negative
    Vec3 tool_step_m = Vec3::Zero();  ///< displacement of the tool point in the step
    double tool_way_m = 0;            ///< the same along the normal
    double old_overlap_m = 0;         ///< there at the start of the step, as far as it still counts as motion
    Vec3 friction_kg_m = Vec3::Zero();  ///< the same as kg_m along the surface, on the tissue
    Vec3 stuck_at_m = Vec3::Zero();     ///< the tissue point had it gone with the tool; only with friction
    double tool_inverse_mass_1_kg = 0;
    Vec3* tool_moved_m = nullptr;  ///< of a tool that is a body: its offset, then its motion
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
  std::vector<Push> pushes_;  ///< one a constraint
  std::vector<Vec3> normals_;
  std::vector<Vec3> start_m_;  ///< positions before the contacts
  std::vector<Vec3> way_m_;    ///< of each vertex in the step before the contacts
  std::vector<Vec3> motion_m_;
};

}  // namespace fissure
