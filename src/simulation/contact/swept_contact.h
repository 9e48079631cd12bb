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
  /// Largest number of further responses, to pairs that cross, after the response to pairs that are near;
  /// then tissue that still crosses is stopped. 0: no response at all.
  int rounds = 4;
  int sweeps = 30;  ///< Gauss-Seidel sweeps over the contacts in each response
  /// Largest displacement per step of a tool that starts in tissue and is freed.
  double max_displacement_m = 0.005;
  std::vector<double> margins_m;    ///< [body] distance at which contacts hold tissue in front of a tool
  std::vector<double> time_scales;  ///< [body] its own time over the scene's; empty: 1 each
  /// [body] and [tool]: the friction coefficient of a contact is the product of the two; empty: frictionless.
  std::vector<double> body_frictions, tool_frictions;
  std::optional<HalfSpace> ground;  ///< no value: the ground is not this method's
  /// The engine's precision, to which positions are rounded before they are checked.
  bool single_precision = false;
};

/// Wall time of SweptContact's steps so far, seconds.
struct SweptTimes {
  double search_s = 0;        ///< search for pairs that are near and that cross
  double displacement_s = 0;  ///< displacing tissue, with its response
  double truncation_s = 0;
  double report_s = 0;  ///< states, counts and the contact patch
};

/// Contact of the whole surface of tools with the whole surface of tissue (contact/METHOD.md 8). Pairs of
/// features that are near when the step begins are held apart by impulses. The result is searched for pairs
/// that cross on the path of the step; these are added, and the response is repeated from the engine's solve.
/// Tissue that still crosses after the last round is stopped on its path (PathTruncation). No step ends with
/// tissue in a tool unless there is no room for it. The ground is a further obstacle; of tissue only fixed
/// vertices can end a step below it. Tissue against itself and against other tissue is not covered. One
/// object belongs to one run.
///
/// Pairs that would cross without any contact are not searched for: in one step the tissue's own stiffness
/// would take it a millimetre into a tool that holds it, and the pairs and normals there change from step to
/// step.
///
/// For force laws the force of a triangle counts in full where a contact is within a margin of the tool and
/// fades out to zero at three margins, so that triangles enter and leave the sum without jumps. Contacts at a
/// vertex count in full for its triangles, others in proportion to their barycentric coordinates. Pairs that
/// cross count only at vertices without a near pair. Contacts with the ground are no colliding state.
///
/// A tool that overlaps tissue in the first step, or after a step without room, is treated as if it stood
/// beside the tissue and returned by max_displacement_m per step (contact/METHOD.md 10).
///
/// A tool that is a body (StepView::tool_bodies) has a new end pose after each response, which the search for
/// crossings uses; stopped tissue pushes it too.
class SweptContact {
 public:
  SweptContact(const Scene& scene, SweptContactSettings settings);

  /// One step, after the engine's own solve: moves the step's positions_m and tool_bodies in place.
  /// inverse_masses: [vertex] 1/kg, 0: fixed. Fills `patch` and all of `outcome` except vertex_contact, which
  /// is in the patch.
  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch);

  /// [vertex] part of its displacement in the last step that changes its velocity.
  std::span<const Vec3> motion_m() const { return impulses_.motion_m(); }
  const DisplacementCounts& displacementCounts() const { return impulses_.counts(); }
  const TruncationCounts& truncationCounts() const { return truncation_.counts(); }
  /// Number of responses so far.
  long long rounds() const { return rounds_; }
  /// Number of steps so far at whose end a tool that started in tissue had not yet returned to its place.
  long long freeingSteps() const { return freeing_steps_; }
  const SweptTimes& times() const { return times_; }

 private:
  /// The pair of features from which a constraint was made.
  struct Source {
    int obstacle = 0;
    SweptPair pair;
    int earlier = -1;  ///< index of the previous constraint with the same first vertex; -1: none
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
  std::vector<SweptObstacle> obstacles_;  ///< all pairs of tool and body, tool by tool
  std::optional<GroundContact> ground_;
  ContactImpulses impulses_;
  PathTruncation truncation_;
  std::vector<double> force_factors_;  ///< [vertex] square of the scene's time over the body's own
  std::vector<double> frictions_;      ///< [vertex] coefficient of its body; empty: no contact has friction
  long long rounds_ = 0, freeing_steps_ = 0;
  SweptTimes times_;

  bool may_overlap_ = true;
  std::vector<Vec3> beside_m_;  ///< [tool] displacement from its position to where it is assumed to be
  /// [tool] assumed poses: at the beginning of the step's path, and, shifted by beside_m_, at the start and
  /// the end of the step.
  std::vector<ToolState> path_from_, tools_before_, tools_now_;
  std::vector<Vec3> solved_m_;  ///< positions before the contacts
  /// Those of tools; during a response those of the ground follow.
  std::vector<ContactConstraint> constraints_;
  std::vector<Source> sources_;             ///< one per constraint of a tool
  std::size_t near_count_ = 0;              ///< number of constraints, the first ones, from near pairs
  std::vector<std::uint8_t> near_contact_;  ///< [vertex] 1: one of these counts at it
  std::vector<int> latest_;  ///< [vertex] index of the last constraint with this first vertex; -1: none
  std::vector<SweptPair> found_;
  std::vector<int> responders_;  ///< vertices of the contacts in the last response, possibly repeated
  std::vector<int> moved_;       ///< those of one body, as indices in it
};

}  // namespace fissure
