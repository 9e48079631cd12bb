#include <limits>

#include "engine/convert.h"
#include "engine/kinematic_tools.h"

namespace fissure {

namespace {

/// Bullet's own soft-rigid contact: kinematic rigid bodies, whose signed distance field the tissue vertices
/// are tested against.
class SdfPipeline : public Pipeline {
 public:
  explicit SdfPipeline(const PipelineContext& context) : world_(context.world), tools_(context) {}

  void moveTools(const std::vector<ToolState>&, const std::vector<ToolState>& now) override {
    tools_.move(now);
  }

  void report(State& state, ContactPatch& patch) override {
    patch.clear();
    state.contact.contact_count = 0;
    int first_vertex = 0;
    for (const auto& soft : world_.bodies()) {
      for (int i = 0; i < soft->m_rcontacts.size(); ++i) {
        const btSoftBody::RContact& contact = soft->m_rcontacts[i];
        const int tool = tools_.indexOf(contact.m_cti.m_colObj);
        if (tool < 0) continue;
        const int vertex = first_vertex + static_cast<int>(contact.m_node - &soft->m_nodes[0]);
        ++state.contact.contact_count;
        // How far a contact displaces the tissue is inside Bullet's solve: tools share by their contacts.
        patch.touchVertex(tool, vertex, 1, fromBullet(contact.m_cti.m_normal), 1);
      }
      first_vertex += soft->m_nodes.size();
    }
    state.contact.candidate_count = state.contact.contact_count;
    // Bullet's solver does not say what its contacts took from the tissue.
    state.contact.reaction_on_tool_N = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    state.contact.tool_reactions_N.clear();
    state.timing.collision_us = world_.world().detection_us;
  }

 private:
  BulletWorld& world_;
  KinematicTools tools_;
};

}  // namespace

std::unique_ptr<Pipeline> makeSdfPipeline(const PipelineContext& context) {
  return std::make_unique<SdfPipeline>(context);
}

}  // namespace fissure
