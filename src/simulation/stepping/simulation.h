#pragma once

#include <span>
#include <vector>

#include "base/record.h"
#include "base/stage_times.h"
#include "base/state.h"

namespace fissure {

/// The world of one run, whatever the engine: soft bodies, ground, tools and one collision pipeline.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Advances by the scenario's time step. `poses`: [tool] poses at the end of the step, scene frame. Fills
  /// all of state() except step, time_s, clamps, couplings and timing.step_us.
  void step(const std::vector<Pose>& poses) { step(poses, {}); }
  /// The same with tools that contacts can push. tool_inverse_masses_1_kg: [tool] 0: the tool follows its
  /// poses; empty: all do. For a tool with a mass the pose determines its velocity at the step's end without
  /// contacts, displacement over step; over substeps the velocity changes linearly from that of the last
  /// step. Its orientation follows the poses. State::tools then has its actual position, and its velocity at
  /// the step's end. Throws std::invalid_argument where the pipeline's contacts cannot push tools.
  virtual void step(const std::vector<Pose>& poses, std::span<const double> tool_inverse_masses_1_kg) = 0;
  /// To be called between two steps, by a run that passes part of its path faster: the tools' speed is
  /// multiplied by `factor` from here on. Where it falls, the tissue's velocities are reduced with it, which
  /// the balances of energy and momentum ignore, and elastic tissue takes as few substeps again as before the
  /// speed last rose.
  virtual void changeTempo(double factor) = 0;
  /// The one State of the run. The caller of step() fills the fields that step() does not.
  virtual State& state() = 0;
  virtual const State& state() const = 0;
  /// Counts of the contact method over the run ("rays", "ray_triangle_tests", "displacement_sweeps",
  /// "displacement_pushes" ...); empty for Bullet's own contacts.
  virtual Summary counters() const = 0;
  /// Wall time of the stages of steps so far: those of the engine, then of the pipeline, then of the force
  /// laws. They do not cover everything that a step does.
  virtual std::vector<StageTime> stageTimes() const = 0;
};

}  // namespace fissure
