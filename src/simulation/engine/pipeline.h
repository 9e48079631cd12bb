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

/// How tools meet tissue: what a pipeline adds to the world, the same for all else. One object belongs to one
/// run.
class Pipeline {
 public:
  virtual ~Pipeline() = default;
  /// Whether contacts push tools that are bodies; where not, all are led.
  virtual bool pushesTools() const { return false; }
  /// Before moveTools: those of the step. They outlive it.
  virtual void setToolBodies(std::span<ToolBody> /*bodies*/) {}
  /// Before Bullet's step: the tools move to their poses at its end.
  virtual void moveTools(const std::vector<ToolState>& before, const std::vector<ToolState>& now) = 0;
  /// After Bullet's step: contacts, counts, reaction and collision time of the step into `state` and `patch`.
  virtual void report(State& state, ContactPatch& patch) = 0;
  virtual Summary counters() const { return {}; }
  /// Of what the pipeline adds to Bullet's own stages.
  virtual std::vector<StageTime> stageTimes() const { return {}; }
};

/// What a pipeline is built from; all references outlive it.
struct PipelineContext {
  const Scenario& scenario;
  const PipelineSettings& settings;
  const Scene& scene;
  BulletWorld& world;
  const std::vector<Pose>& first_poses;
};

/// A collision pipeline: how its detection in Bullet is set up, and its stage in each step.
struct PipelineFactory {
  PipelineKind kind;
  std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> (*configuration)();  ///< null: Bullet's own
  std::unique_ptr<Pipeline> (*make)(const PipelineContext& context);
};

/// The factory of a pipeline; throws std::invalid_argument when this engine has none.
const PipelineFactory& pipelineFactory(PipelineKind kind);

std::unique_ptr<Pipeline> makeSdfPipeline(const PipelineContext& context);
std::unique_ptr<Pipeline> makeClusterPipeline(const PipelineContext& context);
std::unique_ptr<Pipeline> makeMethodPipeline(const PipelineContext& context);
std::unique_ptr<Pipeline> makePrescribedPipeline(const PipelineContext& context);
std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> makeDelegatingConfiguration();

}  // namespace fissure
