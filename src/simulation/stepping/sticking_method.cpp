#include "stepping/sticking_method.h"

#include <optional>
#include <utility>

#include "contact/vertex_sides.h"

namespace fissure {

namespace {

std::vector<double> margins(const Scenario& scenario) {
  std::vector<double> margins_m;
  for (const BodySettings& body : scenario.bodies) margins_m.push_back(body.margin_m);
  return margins_m;
}

class StickingMethod : public ContactMethod {
 public:
  explicit StickingMethod(const ContactMethodContext& context)
      : sides_(context.scene, margins(context.scenario)),
        tool_count_(context.scene.tools.size()),
        held_(context.scene.vertexCount()),
        motion_m_(context.scene.vertexCount()) {}

  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch) override {
    hold(step, inverse_masses);
    patch.clear();
    outcome = {};
    outcome.tool_work_J = 0;
    outcome.tool_reactions_N.assign(tool_count_ > 1 ? tool_count_ : 0, Vec3::Zero());
    for (std::size_t v = 0; v < held_.size(); ++v) {
      motion_m_[v] = Vec3::Zero();
      if (!held_[v]) continue;
      const std::size_t tool = held_[v]->tool;
      const Pose& pose = step.tools_now[tool].pose;
      const Vec3 at_m = pose.toScene(held_[v]->position_m);
      motion_m_[v] = at_m - step.positions_m[v];
      step.positions_m[v] = at_m;
      const Pose& pose_before = step.tools_before[tool].pose;
      const Vec3 on_tool_N = -motion_m_[v] / (inverse_masses[v] * step.dt_s * step.dt_s);
      outcome.reaction_on_tool_N += on_tool_N;
      outcome.tool_work_J -= on_tool_N.dot(at_m - pose_before.toScene(held_[v]->position_m));
      if (tool_count_ > 1) outcome.tool_reactions_N[tool] += on_tool_N;
      ++outcome.contact_count;
      patch.touchVertex(static_cast<int>(tool), static_cast<int>(v), 1, pose.rotateToScene(held_[v]->normal),
                        1);
    }
    outcome.candidate_count = outcome.contact_count;
  }

  std::span<const Vec3> motion_m() const override { return motion_m_; }
  Summary counters() const override { return {}; }
  std::vector<StageTime> stageTimes() const override { return {}; }

 private:
  struct Held {
    std::size_t tool = 0;
    Vec3 position_m, normal;  ///< tool frame
  };

  /// Vertices that reach a tool in this step.
  void hold(const StepView& step, std::span<const double> inverse_masses) {
    reached_.clear();
    sides_.find(step, {}, reached_);
    for (const ContactConstraint& contact : reached_) {
      const int vertex = contact.vertices[0];
      if (held_[vertex] || !(inverse_masses[vertex] > 0)) continue;
      const Pose& pose = step.tools_now[contact.tool].pose;
      const Vec3& point_m = step.positions_m[vertex];
      const double gap_m = (point_m - contact.position_m).dot(contact.normal) - contact.target_m;
      held_[vertex] = Held{.tool = static_cast<std::size_t>(contact.tool),
                           .position_m = pose.toBody(point_m - gap_m * contact.normal),
                           .normal = pose.rotateToBody(contact.normal)};
    }
  }

  VertexSides sides_;
  std::size_t tool_count_;
  std::vector<std::optional<Held>> held_;  ///< per vertex
  std::vector<Vec3> motion_m_;
  std::vector<ContactConstraint> reached_;
};

}  // namespace

std::unique_ptr<ContactMethod> makeStickingMethod(const ContactMethodContext& context) {
  return std::make_unique<StickingMethod>(context);
}

}  // namespace fissure
