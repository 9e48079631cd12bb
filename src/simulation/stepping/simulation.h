#pragma once

#include <span>
#include <vector>

#include "base/record.h"
#include "base/stage_times.h"
#include "base/state.h"

namespace fissure {

/// A running world: soft bodies, ground, tools and one collision pipeline, whatever engine moves them.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Advances by the scenario's time step; `poses` are the tools' at its end. Fills everything of state() but
  /// step, time_s, clamps, couplings and timing.step_us.
  void step(const std::vector<Pose>& poses) { step(poses, {}); }
  /// The same with tools that contacts push. tool_inverse_masses_1_kg: one per tool, 0: it is led; empty: all
  /// are led. Else its pose stands for the velocity that it has at the step's end unless it is pushed, which
  /// is the way to there over the step and is reached from the last step's evenly over the substeps; it turns
  /// as it is led. State::tools then has where it came to, and its velocity at the step's end. Throws
  /// std::invalid_argument where the pipeline's contacts can push no tool.
  virtual void step(const std::vector<Pose>& poses, std::span<const double> tool_inverse_masses_1_kg) = 0;
  /// The one State of the run. What step() leaves out, whoever steps the simulation writes into it.
  virtual State& state() = 0;
  virtual const State& state() const = 0;
  /// Counts of the detector over the run ("rays", "ray_triangle_tests", "displacement_sweeps",
  /// "displacement_pushes"), empty for Bullet's own.
  virtual Summary counters() const = 0;
  /// Wall time of the steps' stages so far, in their order: the engine's, then the pipeline's, then the force
  /// laws'. What else a step does is in none of them.
  virtual std::vector<StageTime> stageTimes() const = 0;
};

}  // namespace fissure
