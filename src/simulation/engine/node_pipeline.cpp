#include <algorithm>
#include <chrono>

#include "contact/node_contact.h"
#include "engine/pipeline.h"

namespace fissure {

namespace {

NodeContactSettings contactSettings(const PipelineContext& context) {
  NodeContactSettings settings{.association = context.settings.traits().association,
                               .vertex_contacts = context.settings.vertexContacts(),
                               .response = context.settings.contactResponse(),
                               .sweeps = context.settings.sweeps,
                               .ray_length_m = context.settings.ray_length_m,
                               .max_displacement_m = context.settings.max_displacement_m,
                               .margins_m = {},
                               .time_scales = {},
                               .body_frictions = {},
                               .tool_frictions = {}};
  for (const BodySettings& body : context.scenario.bodies) {
    settings.margins_m.push_back(body.margin_m);
    settings.time_scales.push_back(body.solver.time_scale);
    settings.body_frictions.push_back(body.solver.dynamic_friction);
  }
  const std::vector<ToolSettings>& tools = context.scenario.tools;
  if (std::any_of(tools.begin(), tools.end(), [](const ToolSettings& tool) { return tool.friction > 0; })) {
    for (const ToolSettings& tool : tools) settings.tool_frictions.push_back(tool.friction);
  }
  return settings;
}

/// The paper's method after Bullet's own solve; the tools are no bodies of Bullet's world.
class NodePipeline : public Pipeline {
 public:
  explicit NodePipeline(const PipelineContext& context)
      : world_(context.world),
        step_s_(context.scenario.time.step_s),
        contact_(context.scene, contactSettings(context)),
        inverse_masses_(context.world.inverseMasses()),
        positions_m_(context.scene.vertexCount()) {
    for (const SceneBody& body : context.scene.bodies)
      before_m_.insert(before_m_.end(), body.rest.vertices_m.begin(), body.rest.vertices_m.end());
    patch_.resize(context.scene.vertexCount(), context.scene.faceCount(),
                  context.scenario.force.empty() ? 0 : context.scene.tools.size());
    world_.solver().setAfterSolve([this] { afterSolve(); });
  }

  void moveTools(const std::vector<ToolState>& before, const std::vector<ToolState>& now) override {
    before_ = before;
    now_ = now;
  }

  void report(State& state, ContactPatch& patch) override {
    std::swap(state.contact, outcome_);
    state.timing.collision_us = collision_us_;
    std::swap(patch, patch_);
  }

  Summary counters() const override {
    return {{"rays", contact_.rays()},
            {"ray_triangle_tests", contact_.rayTests()},
            {"displacement_sweeps", contact_.displacementCounts().sweeps},
            {"displacement_pushes", contact_.displacementCounts().pushes}};
  }

  std::vector<StageTime> stageTimes() const override {
    const ContactTimes& times = contact_.times();
    return {{"rays", times.rays_s},
            {"association", times.association_s},
            {"vertex_contacts", times.vertex_contacts_s},
            {"displacement", times.displacement_s},
            {"report", times.report_s},
            {"transfer", transfer_s_}};
  }

 private:
  void afterSolve() {
    const auto start = std::chrono::steady_clock::now();
    StageClock clock;
    world_.readPositions(positions_m_);
    clock.lap(transfer_s_);
    contact_.step({.positions_m = positions_m_,
                   .before_m = before_m_,
                   .tools_before = before_,
                   .tools_now = now_,
                   .dt_s = step_s_},
                  inverse_masses_, outcome_, patch_);
    clock = {};
    world_.writePositions(positions_m_);
    if (!contact_.motion_m().empty()) world_.addMotion(contact_.motion_m());
    std::swap(before_m_, positions_m_);
    clock.lap(transfer_s_);
    collision_us_ =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  }

  BulletWorld& world_;
  double step_s_;
  NodeContact contact_;
  std::vector<double> inverse_masses_;
  std::vector<Vec3> positions_m_;
  std::vector<Vec3> before_m_;  ///< tissue when the step began: as contacts left it in the last step
  std::vector<ToolState> before_, now_;
  ContactOutcome outcome_;  ///< of the step until it is reported
  ContactPatch patch_;      ///< likewise
  double collision_us_ = 0;
  double transfer_s_ = 0;  ///< of positions and motion between Bullet and the method, so far
};

}  // namespace

std::unique_ptr<Pipeline> makeNodePipeline(const PipelineContext& context) {
  return std::make_unique<NodePipeline>(context);
}

}  // namespace fissure
