#include <BulletCollision/CollisionShapes/btBoxShape.h>

#include <limits>

#include "engine/convert.h"
#include "engine/pipeline.h"

namespace fissure {

namespace {

/// Bullet's own soft-rigid contact: kinematic rigid bodies, whose signed distance field the tissue vertices
/// are tested against.
class SdfPipeline : public Pipeline {
 public:
  explicit SdfPipeline(const PipelineContext& context) : world_(context.world) {
    for (std::size_t t = 0; t < context.scenario.tools.size(); ++t) {
      const ToolSettings& tool = context.scenario.tools[t];
      shapes_.push_back(std::make_unique<btBoxShape>(toBullet(Vec3(0.5 * tool.shape.size_m))));
      btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
      info.m_startWorldTransform = toBullet(context.first_poses[t]);
      info.m_friction = static_cast<btScalar>(tool.friction);
      bodies_.push_back(std::make_unique<btRigidBody>(info));
      btRigidBody& body = *bodies_.back();
      body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
      body.setActivationState(
          DISABLE_DEACTIVATION);  // before it is added: a sleeping tool never gets its velocity
      world_.world().addRigidBody(&body);
    }
  }
  ~SdfPipeline() override {
    for (const auto& body : bodies_) world_.world().removeRigidBody(body.get());
  }

  // Only the world transform: Bullet takes the velocity from its difference to the interpolation transform.
  void moveTools(const std::vector<ToolState>&, const std::vector<ToolState>& now) override {
    for (std::size_t t = 0; t < bodies_.size(); ++t) bodies_[t]->setWorldTransform(toBullet(now[t].pose));
  }

  void report(State& state, ContactPatch& patch) override {
    patch.clear();
    state.contact_count = 0;
    int first_vertex = 0;
    for (const auto& soft : world_.bodies()) {
      for (int i = 0; i < soft->m_rcontacts.size(); ++i) {
        const btSoftBody::RContact& contact = soft->m_rcontacts[i];
        if (!isTool(contact.m_cti.m_colObj)) continue;
        const int vertex = first_vertex + static_cast<int>(contact.m_node - &soft->m_nodes[0]);
        ++state.contact_count;
        patch.vertex_contact[vertex] = 1;
        if (patch.hasNormals()) patch.vertex_normals[vertex] += fromBullet(contact.m_cti.m_normal);
      }
      first_vertex += soft->m_nodes.size();
    }
    state.candidate_count = state.contact_count;
    // Bullet's solver does not say what its contacts took from the tissue.
    state.reaction_on_tool_N = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    state.timing.collision_us = world_.world().detection_us;
  }

 private:
  bool isTool(const btCollisionObject* object) const {
    for (const auto& body : bodies_) {
      if (body.get() == object) return true;
    }
    return false;
  }

  BulletWorld& world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::unique_ptr<Pipeline> makeSdfPipeline(const PipelineContext& context) {
  return std::make_unique<SdfPipeline>(context);
}

}  // namespace fissure
