#include "stepping/sticking_method.h"

#include <optional>

#include "contact/held_vertices.h"

namespace fissure {

namespace {

class StickingMethod : public ContactMethod {
 public:
  explicit StickingMethod(const ContactMethodContext& context)
      : held_(context.scene, marginsOf(context.scenario)),
        tool_count_(context.scene.tools.size()),
        motion_m_(context.scene.vertexCount()) {}

  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch) override {
    held_.hold(step, inverse_masses);
    patch.clear();
    outcome.contact_count = 0;
    outcome.reaction_on_tool_N = Vec3::Zero();
    outcome.tool_work_J = 0;
    outcome.tool_reactions_N.assign(tool_count_ > 1 ? tool_count_ : 0, Vec3::Zero());
    for (std::size_t v = 0; v < motion_m_.size(); ++v) {
      motion_m_[v] = Vec3::Zero();
      const std::optional<HeldVertices::Held>& held = held_.vertices()[v];
      if (!held) continue;
      const auto tool = static_cast<std::size_t>(held->tool);
      const Pose& pose = step.tools_now[tool].pose;
      const Vec3 at_m = pose.toScene(held->position_m);
      motion_m_[v] = at_m - step.positions_m[v];
      step.positions_m[v] = at_m;
      const Pose& pose_before = step.tools_before[tool].pose;
      const Vec3 on_tool_N = -motion_m_[v] / (inverse_masses[v] * step.dt_s * step.dt_s);
      outcome.reaction_on_tool_N += on_tool_N;
      outcome.tool_work_J -= on_tool_N.dot(at_m - pose_before.toScene(held->position_m));
      if (tool_count_ > 1) outcome.tool_reactions_N[tool] += on_tool_N;
      ++outcome.contact_count;
      patch.touchVertex(held->tool, static_cast<int>(v), 1, pose.rotateToScene(held->normal), 1);
    }
    outcome.candidate_count = outcome.contact_count;
  }

  std::span<const Vec3> motion_m() const override { return motion_m_; }
  Summary counters() const override { return {}; }
  std::vector<StageTime> stageTimes() const override { return {}; }

 private:
  HeldVertices held_;
  std::size_t tool_count_;
  std::vector<Vec3> motion_m_;
};

}  // namespace

std::unique_ptr<ContactMethod> makeStickingMethod(const ContactMethodContext& context) {
  return std::make_unique<StickingMethod>(context);
}

}  // namespace fissure
