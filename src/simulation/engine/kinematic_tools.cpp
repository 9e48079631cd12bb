#include "engine/kinematic_tools.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include "base/error.h"
#include "engine/convert.h"
#include "mesh/convex.h"

namespace fissure {

namespace {

std::unique_ptr<btConvexShape> makeToolShape(const SceneTool& tool) {
  if (tool.box_size_m) return std::make_unique<btBoxShape>(toBullet(Vec3(0.5 * *tool.box_size_m)));
  if (!tool.closed || !isConvex(tool.surface))
    throw InputError("tool '" + tool.name +
                     "' is not convex and closed, expected pipelines raycast, fukuhara and swept alone");
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Vec3& vertex : tool.surface.vertices_m) hull->addPoint(toBullet(vertex), false);
  hull->recalcLocalAabb();
  hull->setMargin(0);  // Bullet's own would make the tool 80 mm thicker
  return hull;
}

}  // namespace

KinematicTools::KinematicTools(btDynamicsWorld& world, const Scenario& scenario, const Scene& scene,
                               const std::vector<Pose>& first_poses)
    : world_(world) {
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const ToolSettings& tool = scenario.tools[t];
    shapes_.push_back(makeToolShape(scene.tools[t]));
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
    info.m_startWorldTransform = toBullet(first_poses[t]);
    info.m_friction = static_cast<btScalar>(tool.friction);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    body.setActivationState(
        DISABLE_DEACTIVATION);  // before it is added: a sleeping tool never gets its velocity
    world_.addRigidBody(&body);
  }
}

KinematicTools::~KinematicTools() {
  for (const auto& body : bodies_) world_.removeRigidBody(body.get());
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
