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

/// The State of a run and what every engine does with it alike: tools that move from pose to pose, and force
/// laws evaluated over the step's contacts. The engine writes tissue and contacts.
class SteppedState {
 public:
  /// masses_kg: one per vertex of the scene, 0: fixed.
  SteppedState(const Scenario& scenario, const Scene& scene, const std::vector<Pose>& first_poses,
               std::vector<double> masses_kg);

  /// The tools move to `poses`, which they have at the step's end. tool_inverse_masses_1_kg: one per tool;
  /// empty: all are led.
  void beginStep(const std::vector<Pose>& poses, std::span<const double> tool_inverse_masses_1_kg);
  /// After the engine's step: what touched, and the forces of the laws.
  void endStep();

  const std::vector<ToolState>& toolsBefore() const { return before_; }
  State& state() { return state_; }
  const State& state() const { return state_; }
  ContactPatch& patch() { return patch_; }
  /// Of this step, for its StepView; empty: all tools are led.
  std::span<ToolBody> toolBodies() { return bodies_; }
  /// Adds the laws' stage, where there are laws.
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
