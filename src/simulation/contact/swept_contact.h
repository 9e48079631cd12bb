#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/scene.h"
#include "base/stage_times.h"
#include "base/state.h"
#include "contact/contact_impulses.h"
#include "contact/contact_patch.h"
#include "contact/ground_contact.h"
#include "contact/path_truncation.h"
#include "contact/step_view.h"
#include "contact/swept_obstacle.h"

namespace fissure {

struct SweptContactSettings {
  /// Responses to what crosses a tool, at most, after the one to what is near; then tissue that still crosses
  /// is stopped. 0: no response at all.
  int rounds = 4;
  int sweeps = 30;                    ///< Gauss-Seidel sweeps over the contacts in each of them
  double max_displacement_m = 0.005;  ///< way on which a tool that starts in tissue is freed in a step
  std::vector<double> margins_m;      ///< one a body: how far in front of the tool the tissue is held
  std::vector<double> time_scales;    ///< one a body: its own time over the scene's; empty: 1 each
  /// Coulomb's coefficient of tissue on tool is the product of the body's and the tool's; empty:
  /// frictionless.
  std::vector<double> body_frictions, tool_frictions;
  std::optional<HalfSpace> ground;  ///< no value: none of this method's
  bool single_precision = false;    ///< of the engine: positions are rounded to it before they are checked
};

/// Wall time of SweptContact's steps so far, seconds.
struct SweptTimes {
  double search_s = 0;        ///< for pairs that are near and for pairs that cross
  double displacement_s = 0;  ///< of the tissue, with its response
  double truncation_s = 0;
  double report_s = 0;  ///< states, counts and the patch of contacts
};

/// Contact of all of the tools' surface with all of the tissue's (METHOD section 9): pairs that are near when
/// the step begins are held apart by impulses; the result is searched for pairs that cross on the path of the
/// step, and these are held apart too, from the engine's solve again. What still crosses after the last round
/// is stopped on its path. No step ends with tissue in a tool but where there is no room for it. The ground
/// is one more such obstacle, with contacts of its own among those of the tools, and no step ends with tissue
/// below it but with fixed vertices. Tissue against itself and against other tissue is not covered. One
/// object belongs to one run.
///
/// What would cross without any contact is not looked for: in one step the tissue's own stiffness would take
/// it a millimetre into a tool that holds it, and which pairs it crosses there, with which normals, changes
/// from step to step.
///
/// The force of a triangle counts in full where a contact holds it, and fades out as contacts are farther
/// from the tool than a margin: at three margins none counts. Contacts at a vertex count in full for its
/// triangles, others in proportion to their barycentric coordinates. So triangles come and go without jumps.
/// Pairs that cross count only at vertices where none was near. Contacts with the ground are no colliding
/// state.
///
/// A tool that overlaps tissue in the first step, or after a step without room, is taken for one that stands
/// beside it and comes back, max_displacement_m a step.
///
/// A tool that is a body (StepView::tool_bodies) has another end pose after each response: what crosses is
/// looked for against that, and what is stopped pushes it too.
class SweptContact {
 public:
  SweptContact(const Scene& scene, SweptContactSettings settings);

  /// One step, after the engine's own solve: moves its positions_m and tool_bodies in place. inverse_masses:
  /// one per vertex in 1/kg, 0: fixed. Fills `patch` and all of `outcome` but vertex_contact, which the patch
  /// has.
  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch);

  /// The share of each vertex's displacement in the last step that changes its velocity.
  std::span<const Vec3> motion_m() const { return impulses_.motion_m(); }
  const DisplacementCounts& displacementCounts() const { return impulses_.counts(); }
  const TruncationCounts& truncationCounts() const { return truncation_.counts(); }
  long long rounds() const { return rounds_; }
  /// Steps at whose end a tool that stood in tissue had not come back to its place.
  long long freeingSteps() const { return freeing_steps_; }
  const SweptTimes& times() const { return times_; }

 private:
  /// What a constraint stems from.
  struct Source {
    int obstacle = 0;
    SweptPair pair;
    int earlier = -1;  ///< the constraint before it with the same first vertex
  };

  void placeTools(const StepView& step);
  void freeTools(const StepView& step);
  void findNear(const StepView& step);
  bool findCrossings(const StepView& step, bool whole_paths);
  void findMoved(const SweptObstacle& obstacle);
  void shareRoom(const StepView& step);
  void respond(const StepView& step, std::span<const double> inverse_masses);
  void add(const StepView& step, const Source& source);
  int indexOf(const Source& source) const;
  ContactConstraint constraintOf(const StepView& step, const Source& source) const;
  void report(const StepView& step, ContactOutcome& outcome, ContactPatch& patch);
  void touch(const StepView& step, std::size_t index, std::span<const std::uint8_t> but_at,
             ContactPatch& patch) const;

  SweptContactSettings settings_;
  std::size_t body_count_, tool_count_;
  int face_count_;
  std::vector<SweptObstacle> obstacles_;  ///< tool by tool, body by body
  std::optional<GroundContact> ground_;
  ContactImpulses impulses_;
  PathTruncation truncation_;
  std::vector<double> force_factors_;  ///< one a vertex: the scene's time over its own, squared
  std::vector<double> frictions_;      ///< one a vertex: its body's; empty: no contact has friction
  long long rounds_ = 0, freeing_steps_ = 0;
  SweptTimes times_;

  bool may_overlap_ = true;
  std::vector<Vec3> beside_m_;  ///< one a tool: from where it is to where it is taken to be
  /// Tools as contacts take them: where the path of the step begins, and, `beside` alike at both ends, when
  /// the step began and now.
  std::vector<ToolState> path_from_, tools_before_, tools_now_;
  std::vector<Vec3> solved_m_;                  ///< positions before the contacts
  std::vector<ContactConstraint> constraints_;  ///< of tools; in a response those of the ground follow
  std::vector<Source> sources_;                 ///< one a constraint of a tool
  std::size_t near_count_ = 0;  ///< how many of them, the first ones, were near when the step began
  std::vector<std::uint8_t> near_contact_;  ///< per vertex, 1: one of those counts at it
  std::vector<int> latest_;  ///< per vertex: the last constraint with it as its first vertex; -1: none
  std::vector<SweptPair> found_;
  std::vector<int> responders_;  ///< vertices of contacts in the last response, some more than once
  std::vector<int> moved_;       ///< those of one body, indices in it
};

}  // namespace fissure
