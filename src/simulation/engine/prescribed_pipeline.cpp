#include <limits>
#include <optional>

#include "contact/vertex_sides.h"
#include "engine/convert.h"
#include "engine/pipeline.h"

namespace fissure {

namespace {

/// The reference for what is the tissue's own in a force curve: vertices that a box tool reaches are fixed to
/// it from then on, so that it is compressed by prescribed vertices, without contacts that come and go.
class PrescribedPipeline : public Pipeline {
 public:
  explicit PrescribedPipeline(const PipelineContext& context)
      : world_(context.world),
        step_s_(context.scenario.time.step_s),
        sides_(context.scene, margins(context.scenario)),
        held_(context.scene.vertexCount()),
        inverse_masses_(world_.inverseMasses()),
        predicted_m_(context.scene.vertexCount()),
        before_m_(context.scene.vertexCount()) {
    world_.readPositions(before_m_);
    world_.solver().setBeforeSolve([this] { prescribe(); });
    world_.solver().setAfterSolve([this] { world_.readPositions(before_m_); });
  }

  void moveTools(const std::vector<ToolState>& before, const std::vector<ToolState>& now) override {
    before_ = before;
    now_ = now;
  }

  void report(State& state, ContactPatch& patch) override {
    patch.clear();
    state.contact.contact_count = 0;
    for (std::size_t v = 0; v < held_.size(); ++v) {
      if (!held_[v]) continue;
      ++state.contact.contact_count;
      const int tool = held_[v]->tool;
      patch.touchVertex(tool, static_cast<int>(v), 1, now_[tool].pose.rotateToScene(held_[v]->normal), 1);
    }
    state.contact.candidate_count = state.contact.contact_count;
    // What holds the vertices is not measured.
    state.contact.reaction_on_tool_N = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    state.contact.tool_reactions_N.clear();
    state.timing.collision_us = 0;
  }

 private:
  struct Held {
    int tool = 0;
    Vec3 position_m, normal;  ///< tool frame
  };

  static std::vector<double> margins(const Scenario& scenario) {
    std::vector<double> margins_m;
    for (const BodySettings& body : scenario.bodies) margins_m.push_back(body.margin_m);
    return margins_m;
  }

  // On the predicted positions: a held vertex has no mass that could be moved, and its tool's place.
  void prescribe() {
    world_.readPositions(predicted_m_);
    reached_.clear();
    sides_.find({.positions_m = predicted_m_,
                 .before_m = before_m_,
                 .tools_before = before_,
                 .tools_now = now_,
                 .dt_s = step_s_},
                {}, reached_);
    for (const ContactConstraint& contact : reached_) {
      std::optional<Held>& held = held_[contact.vertices[0]];
      if (held || !(inverse_masses_[contact.vertices[0]] > 0)) continue;
      const Pose& pose = now_[contact.tool].pose;
      const Vec3& point_m = predicted_m_[contact.vertices[0]];
      const double gap_m = (point_m - contact.position_m).dot(contact.normal) - contact.target_m;
      held = Held{.tool = contact.tool,
                  .position_m = pose.toBody(point_m - gap_m * contact.normal),
                  .normal = pose.rotateToBody(contact.normal)};
    }
    std::size_t vertex = 0;
    for (const auto& body : world_.bodies()) {
      bool more = false;
      for (int i = 0; i < body->m_nodes.size(); ++i) {
        const std::optional<Held>& held = held_[vertex++];
        if (!held) continue;
        more = more || body->m_nodes[i].m_im > 0;
        body->m_nodes[i].m_im = 0;
        body->m_nodes[i].m_x = toBullet(now_[held->tool].pose.toScene(held->position_m));
      }
      if (more) updateLinkMobilities(*body);
    }
  }

  // Links keep the mobility of their ends, as it was when they were made. Where both ends are held any
  // positive number serves: they do not move.
  static void updateLinkMobilities(btSoftBody& body) {
    body.updateLinkConstants();
    for (int i = 0; i < body.m_links.size(); ++i) {
      if (!(body.m_links[i].m_c0 > 0)) body.m_links[i].m_c0 = btScalar(1e-12);
    }
  }

  BulletWorld& world_;
  double step_s_;
  VertexSides sides_;
  std::vector<std::optional<Held>> held_;  ///< per vertex
  std::vector<double> inverse_masses_;     ///< as the scene has them; 0: fixed, not to be held
  std::vector<Vec3> predicted_m_;
  std::vector<Vec3> before_m_;  ///< as the last step left it
  std::vector<ContactConstraint> reached_;
  std::vector<ToolState> before_, now_;
};

}  // namespace

std::unique_ptr<Pipeline> makePrescribedPipeline(const PipelineContext& context) {
  return std::make_unique<PrescribedPipeline>(context);
}

}  // namespace fissure
