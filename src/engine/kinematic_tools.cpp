#include "engine/kinematic_tools.h"

#include "engine/convert.h"

namespace fissure {

KinematicTools::KinematicTools(const PipelineContext& context) : world_(context.world) {
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

KinematicTools::~KinematicTools() {
  for (const auto& body : bodies_) world_.world().removeRigidBody(body.get());
}

// Only the world transform: Bullet takes the velocity from its difference to the interpolation transform.
void KinematicTools::move(const std::vector<ToolState>& now) {
  for (std::size_t t = 0; t < bodies_.size(); ++t) bodies_[t]->setWorldTransform(toBullet(now[t].pose));
}

int KinematicTools::indexOf(const btCollisionObject* object) const {
  for (std::size_t t = 0; t < bodies_.size(); ++t) {
    if (bodies_[t].get() == object) return static_cast<int>(t);
  }
  return -1;
}

}  // namespace fissure
