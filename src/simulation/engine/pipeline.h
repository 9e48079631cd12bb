#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/record.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/step_view.h"
#include "engine/bullet_world.h"

namespace fissure {

/// The part of the Bullet world that depends on the pipeline: contact between tools and tissue. One object
/// belongs to one run.
class Pipeline {
 public:
  virtual ~Pipeline() = default;
  /// Whether contacts can push tools with a mass (StepView::tool_bodies).
  virtual bool pushesTools() const { return false; }
  /// Sets the tools with a mass for the step, which outlive the step; to be called before moveTools().
  virtual void setToolBodies(std::span<ToolBody> /*bodies*/) {}
  /// Moves the tools from their states at the step's start to those at its end; to be called before Bullet's
  /// step.
  virtual void moveTools(const std::vector<ToolState>& before, const std::vector<ToolState>& now) = 0;
  /// Writes contacts, counts, reaction and collision time of the step into `state` and `patch`; to be called
  /// after Bullet's step.
  virtual void report(State& state, ContactPatch& patch) = 0;
  virtual Summary counters() const { return {}; }
  /// Wall time so far of the stages that the pipeline adds to Bullet's own.
  virtual std::vector<StageTime> stageTimes() const { return {}; }
};

/// The arguments for building a pipeline; all references outlive it.
struct PipelineContext {
  const Scenario& scenario;
  const PipelineSettings& settings;
  const Scene& scene;
  BulletWorld& world;
  const std::vector<Pose>& first_poses;
};

/// The maker of a collision pipeline and of its collision configuration in Bullet.
struct PipelineFactory {
  PipelineKind kind;
  std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> (*configuration)();  ///< null: Bullet's own
  std::unique_ptr<Pipeline> (*make)(const PipelineContext& context);
};

/// The factory of a pipeline. Throws std::invalid_argument when this engine has none.
const PipelineFactory& pipelineFactory(PipelineKind kind);

std::unique_ptr<Pipeline> makeSdfPipeline(const PipelineContext& context);
std::unique_ptr<Pipeline> makeClusterPipeline(const PipelineContext& context);
std::unique_ptr<Pipeline> makeMethodPipeline(const PipelineContext& context);
std::unique_ptr<Pipeline> makePrescribedPipeline(const PipelineContext& context);
std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> makeDelegatingConfiguration();

}  // namespace fissure
