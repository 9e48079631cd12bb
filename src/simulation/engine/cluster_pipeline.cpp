#include <limits>

#include "engine/convert.h"
#include "engine/kinematic_tools.h"

namespace fissure {

namespace {

/// Bullet's contact of clusters: pieces of tissue, each a convex hull of its vertices that moves rigidly in
/// the contact, against the convex tool by GJK. All vertices of a cluster in contact collide.
class ClusterPipeline : public Pipeline {
 public:
  explicit ClusterPipeline(const PipelineContext& context) : world_(context.world), tools_(context) {
    patch_.resize(context.scene.vertexCount(), context.scene.faceCount(),
                  context.scenario.force.empty() ? 0 : context.scene.tools.size());
    patch_.clear();
    world_.world().setAfterDetection([this] { readJoints(); });
  }
  ~ClusterPipeline() override { world_.world().setAfterDetection({}); }

  void moveTools(const std::vector<ToolState>&, const std::vector<ToolState>& now) override {
    tools_.move(now);
  }

  void report(State& state, ContactPatch& patch) override {
    std::swap(patch, patch_);
    state.contact.contact_count = state.contact.candidate_count = contacts_;
    // Bullet's solver does not say what its contacts took from the tissue.
    state.contact.reaction_on_tool_N = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    state.contact.tool_reactions_N.clear();
    state.timing.collision_us = world_.world().detection_us;
  }

 private:
  /// Contact joints live from detection to the solve of the same step.
  void readJoints() {
    patch_.clear();
    contacts_ = 0;
    int first_vertex = 0;
    for (const auto& soft : world_.bodies()) {
      for (int i = 0; i < soft->m_joints.size(); ++i) {
        if (soft->m_joints[i]->Type() != btSoftBody::Joint::eType::Contact) continue;
        const auto& joint = *static_cast<const btSoftBody::CJoint*>(soft->m_joints[i]);
        const int tool = tools_.indexOf(joint.m_bodies[1].m_collisionObject);
        if (tool < 0) continue;
        ++contacts_;
        const Vec3 normal = fromBullet(joint.m_normal);
        for (int j = 0; j < joint.m_bodies[0].m_soft->m_nodes.size(); ++j) {
          const btSoftBody::Node* node = joint.m_bodies[0].m_soft->m_nodes[j];
          const int vertex = first_vertex + static_cast<int>(node - &soft->m_nodes[0]);
          patch_.touchVertex(tool, vertex, 1, normal, 1);
        }
      }
      first_vertex += soft->m_nodes.size();
    }
  }

  BulletWorld& world_;
  KinematicTools tools_;
  ContactPatch patch_;
  int contacts_ = 0;
};

}  // namespace

std::unique_ptr<Pipeline> makeClusterPipeline(const PipelineContext& context) {
  return std::make_unique<ClusterPipeline>(context);
}

}  // namespace fissure
