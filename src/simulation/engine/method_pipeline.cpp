#include <chrono>
#include <utility>

#include "base/stage_times.h"
#include "engine/pipeline.h"
#include "engine/simulation.h"
#include "stepping/contact_method.h"

namespace fissure {

namespace {

/// A contact method of ours after Bullet's own solve; the tools are no bodies of Bullet's world.
class MethodPipeline : public Pipeline {
 public:
  explicit MethodPipeline(const PipelineContext& context)
      : method_(makeContactMethod({.scenario = context.scenario,
                                   .settings = context.settings,
                                   .scene = context.scene,
                                   .precision = enginePrecision()})),
        world_(context.world),
        step_s_(context.scenario.time.step_s),
        inverse_masses_(context.world.inverseMasses()),
        positions_m_(context.scene.vertexCount()) {
    for (const SceneBody& body : context.scene.bodies)
      before_m_.insert(before_m_.end(), body.rest.vertices_m.begin(), body.rest.vertices_m.end());
    patch_.resize(context.scene.vertexCount(), context.scene.faceCount(),
                  context.scenario.force.empty() ? 0 : context.scene.tools.size());
    world_.solver().setAfterSolve([this] { afterSolve(); });
  }

  bool pushesTools() const override { return method_->pushesTools(); }
  void setToolBodies(std::span<ToolBody> bodies) override { tool_bodies_ = bodies; }

  void moveTools(const std::vector<ToolState>& before, const std::vector<ToolState>& now) override {
    before_ = before;
    now_ = now;
  }

  void report(State& state, ContactPatch& patch) override {
    std::swap(state.contact, outcome_);
    state.timing.collision_us = collision_us_;
    std::swap(patch, patch_);
  }

  Summary counters() const override { return method_->counters(); }

  std::vector<StageTime> stageTimes() const override {
    std::vector<StageTime> stages = method_->stageTimes();
    stages.push_back({"transfer", transfer_s_});
    return stages;
  }

 private:
  void afterSolve() {
    const auto start = std::chrono::steady_clock::now();
    StageClock clock;
    world_.readPositions(positions_m_);
    clock.lap(transfer_s_);
    method_->step({.positions_m = positions_m_,
                   .before_m = before_m_,
                   .tools_before = before_,
                   .tools_now = now_,
                   .tool_bodies = tool_bodies_,
                   .dt_s = step_s_},
                  inverse_masses_, outcome_, patch_);
    clock = {};
    world_.writePositions(positions_m_);
    if (!method_->motion_m().empty()) world_.addMotion(method_->motion_m());
    std::swap(before_m_, positions_m_);
    clock.lap(transfer_s_);
    collision_us_ =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  }

  std::unique_ptr<ContactMethod> method_;
  BulletWorld& world_;
  double step_s_;
  std::vector<double> inverse_masses_;
  std::vector<Vec3> positions_m_;
  std::vector<Vec3> before_m_;  ///< tissue when the step began: as contacts left it in the last step
  std::vector<ToolState> before_, now_;
  std::span<ToolBody> tool_bodies_;  ///< of the step, which owns them
  ContactOutcome outcome_;           ///< of the step until it is reported
  ContactPatch patch_;               ///< likewise
  double transfer_s_ = 0;            ///< of positions and motion between Bullet and the method, so far
  double collision_us_ = 0;
};

}  // namespace

std::unique_ptr<Pipeline> makeMethodPipeline(const PipelineContext& context) {
  return std::make_unique<MethodPipeline>(context);
}

}  // namespace fissure
