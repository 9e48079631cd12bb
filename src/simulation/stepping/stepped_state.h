#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/scene.h"
#include "base/stage_times.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/step_view.h"
#include "contact/triangle_forces.h"
#include "scenario/scenario.h"

namespace fissure {

/// The State of a run with the work on it that all engines share: tools are moved from pose to pose, and
/// force laws are evaluated over the step's contacts. The engine itself writes tissue and contacts.
class SteppedState {
 public:
  /// first_poses: [tool] scene frame. masses_kg: [vertex] 0: fixed.
  SteppedState(const Scenario& scenario, const Scene& scene, const std::vector<Pose>& first_poses,
               std::vector<double> masses_kg);

  /// Begins a step in which the tools move to `poses`. tool_inverse_masses_1_kg: as for Simulation::step().
  void beginStep(const std::vector<Pose>& poses, std::span<const double> tool_inverse_masses_1_kg);
  /// Ends a step after the engine's part: copies the contact patch into the state and evaluates the force
  /// laws.
  void endStep();

  /// [tool] states when the step began.
  const std::vector<ToolState>& toolsBefore() const { return before_; }
  State& state() { return state_; }
  const State& state() const { return state_; }
  ContactPatch& patch() { return patch_; }
  /// [tool] masses for the StepView of this step; empty: contacts push no tool.
  std::span<ToolBody> toolBodies() { return bodies_; }
  /// Appends the wall time of the force laws, where there are any.
  void addStageTimes(std::vector<StageTime>& stages) const;

 private:
  double step_s_;
  std::unique_ptr<TriangleForces> forces_;  ///< null: no law
  std::vector<ToolState> before_;
  std::vector<ToolBody> bodies_;
  ContactPatch patch_;
  double forces_s_ = 0;
  State state_;
};

}  // namespace fissure
