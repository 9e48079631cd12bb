#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/record.h"
#include "base/scene.h"
#include "base/stage_times.h"
#include "base/state.h"
#include "scenario/scenario.h"

namespace fissure {

/// A running world: soft bodies, ground, kinematic tools and one collision pipeline. No Bullet type crosses
/// this header.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Advances by the scenario's time step; `poses` are the tools' at its end. Fills everything of state() but
  /// step, time_s, clamps, couplings and timing.step_us.
  virtual void step(const std::vector<Pose>& poses) = 0;
  /// The one State of the run. What step() leaves out, whoever steps the simulation writes into it.
  virtual State& state() = 0;
  virtual const State& state() const = 0;
  /// Counts of the detector over the run ("rays", "ray_triangle_tests", "displacement_sweeps",
  /// "displacement_pushes"), empty for Bullet's own.
  virtual Summary counters() const = 0;
  /// Wall time of the steps' stages so far, in their order: Bullet's, then the pipeline's, then the force
  /// laws'. What else a step does is in none of them.
  virtual std::vector<StageTime> stageTimes() const = 0;
};

/// Builds the world of one run with its tools at `first_poses`. Throws std::invalid_argument for a pipeline
/// that this engine does not have.
std::unique_ptr<Simulation> makeSimulation(const Scenario& scenario, const PipelineSettings& pipeline,
                                           const Scene& scene, const std::vector<Pose>& first_poses);

/// The pipelines that this engine can build; a test says that they are those of pipeline_table.
std::vector<PipelineKind> enginePipelines();

/// "Bullet 3.24, double precision".
std::string engineVersion();

/// The precision that this engine was built in.
Precision enginePrecision();

}  // namespace fissure
