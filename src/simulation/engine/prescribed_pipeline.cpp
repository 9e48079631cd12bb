#include <limits>
#include <optional>

#include "contact/held_vertices.h"
#include "engine/convert.h"
#include "engine/pipeline.h"
#include "stepping/contact_method.h"

namespace fissure {

namespace {

/// The reference for what is the tissue's own in a force curve: vertices that a box tool reaches are fixed to
/// it from then on, so that it is compressed by prescribed vertices, without contacts that come and go.
class PrescribedPipeline : public Pipeline {
 public:
  explicit PrescribedPipeline(const PipelineContext& context)
      : world_(context.world),
        step_s_(context.scenario.time.step_s),
        held_(context.scene, marginsOf(context.scenario)),
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
    for (std::size_t v = 0; v < held_.vertices().size(); ++v) {
      const std::optional<HeldVertices::Held>& held = held_.vertices()[v];
      if (!held) continue;
      ++state.contact.contact_count;
      patch.touchVertex(held->tool, static_cast<int>(v), 1, now_[held->tool].pose.rotateToScene(held->normal),
                        1);
    }
    state.contact.candidate_count = state.contact.contact_count;
    // What holds the vertices is not measured.
    state.contact.reaction_on_tool_N = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    state.contact.tool_reactions_N.clear();
    state.timing.collision_us = 0;
  }

 private:
  // On the predicted positions: a held vertex has no mass that could be moved, and its tool's place. Its
  // velocity leads there too, because Bullet's velocity iterations take positions from velocities anew.
  void prescribe() {
    world_.readPositions(predicted_m_);
    held_.hold({.positions_m = predicted_m_,
                .before_m = before_m_,
                .tools_before = before_,
                .tools_now = now_,
                .dt_s = step_s_},
               inverse_masses_);
    std::size_t vertex = 0;
    for (const auto& body : world_.bodies()) {
      bool more = false;
      for (int i = 0; i < body->m_nodes.size(); ++i) {
        const std::optional<HeldVertices::Held>& held = held_.vertices()[vertex++];
        if (!held) continue;
        btSoftBody::Node& node = body->m_nodes[i];
        more = more || node.m_im > 0;
        node.m_im = 0;
        node.m_x = toBullet(now_[held->tool].pose.toScene(held->position_m));
        node.m_v = (node.m_x - node.m_q) * body->m_sst.isdt;
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
  HeldVertices held_;
  std::vector<double> inverse_masses_;  ///< as the scene has them; 0: fixed, not to be held
  std::vector<Vec3> predicted_m_;
  std::vector<Vec3> before_m_;  ///< as the last step left it
  std::vector<ToolState> before_, now_;
};

}  // namespace

std::unique_ptr<Pipeline> makePrescribedPipeline(const PipelineContext& context) {
  return std::make_unique<PrescribedPipeline>(context);
}

}  // namespace fissure
