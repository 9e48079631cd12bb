#include "engine/bullet_world.h"

#include <algorithm>
#include <chrono>

#include "engine/collision_pools.h"
#include "engine/convert.h"
#include "engine/soft_body.h"

namespace fissure {

void StagedSoftBodySolver::predictMotion(btScalar) {
  StageClock clock;
  btDefaultSoftBodySolver::predictMotion(static_cast<btScalar>(step_s_));
  for (const PoseMatching& body : matched_) body.apply();
  clock.lap(predict_s);
}

void StagedSoftBodySolver::solveConstraints(btScalar step_s) {
  StageClock clock;
  if (ground_) {
    for (int i = 0; i < m_softBodySet.size(); ++i) ground_->addContacts(*m_softBodySet[i]);
  }
  clock.lap(solve_s);
  if (before_solve_) before_solve_();
  clock = {};
  if (preview_) preview_->lift(m_softBodySet);
  btDefaultSoftBodySolver::solveConstraints(step_s);
  if (preview_) preview_->takeBack(m_softBodySet);
  clock.lap(solve_s);
  if (after_solve_) after_solve_();
}

void TimedWorld::performDiscreteCollisionDetection() {
  const auto start = std::chrono::steady_clock::now();
  btSoftRigidDynamicsWorld::performDiscreteCollisionDetection();
  if (after_detection_) after_detection_();
  detection_us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  detection_s += 1e-6 * detection_us;
}

BulletWorld::BulletWorld(const Scenario& scenario, const PipelineSettings& pipeline, const Scene& scene,
                         std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> configuration)
    : step_s_(scenario.time.step_s),
      configuration_(configuration
                         ? std::move(configuration)
                         : std::make_unique<btSoftBodyRigidBodyCollisionConfiguration>(collisionPools())),
      dispatcher_(std::make_unique<btCollisionDispatcher>(configuration_.get())),
      broadphase_(std::make_unique<btDbvtBroadphase>()),
      rigid_solver_(std::make_unique<btSequentialImpulseConstraintSolver>()),
      ground_(scenario.ground && !pipeline.ownGround() ? std::make_unique<Ground>(*scenario.ground)
                                                       : nullptr),
      solver_(std::make_unique<StagedSoftBodySolver>(step_s_, ground_.get())),
      world_(std::make_unique<TimedWorld>(dispatcher_.get(), broadphase_.get(), rigid_solver_.get(),
                                          configuration_.get(), solver_.get())) {
  const btVector3 gravity = toBullet(scenario.world.gravity_m_s2);
  world_->setGravity(gravity);
  btSoftBodyWorldInfo& info = world_->getWorldInfo();
  info.m_gravity = gravity;
  info.air_density = static_cast<btScalar>(scenario.world.air_density_kg_m3);
  // Bullet 3.24 reads water but then gives every medium the density of air: no field of a scenario.
  info.water_density = 0;
  info.water_offset = 0;
  info.water_normal = btVector3(0, 0, 0);
  info.m_maxDisplacement = static_cast<btScalar>(scenario.world.max_displacement_m);
  info.m_sparsesdf.setDefaultVoxelsz(static_cast<btScalar>(pipeline.sdfVoxel_m()));
  info.m_sparsesdf.Reset();  // a new voxel size applies from here on
  if (scenario.ground && !ground_) solver_->showGround(scenario.ground->height_m);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    bodies_.push_back(makeSoftBody(info, scene.bodies[b].rest, scenario.bodies[b], pipeline,
                                   scene.bodies[b].fixed_vertices));
    world_->addSoftBody(bodies_.back().get());
    if (PoseMatching::isNeededFor(*bodies_.back())) solver_->matchPose(*bodies_.back());
  }
}

BulletWorld::~BulletWorld() {
  for (const auto& body : bodies_) world_->removeSoftBody(body.get());
}

void BulletWorld::step() {
  const btScalar step_s = static_cast<btScalar>(step_s_);
  world_->stepSimulation(step_s, 1, step_s);
}

std::vector<StageTime> BulletWorld::stageTimes() const {
  return {{"predict", solver_->predict_s}, {"detection", world_->detection_s}, {"solve", solver_->solve_s}};
}

void BulletWorld::readPositions(std::vector<Vec3>& positions_m) const {
  std::size_t vertex = 0;
  for (const auto& body : bodies_) {
    for (int i = 0; i < body->m_nodes.size(); ++i) positions_m[vertex++] = fromBullet(body->m_nodes[i].m_x);
  }
}

void BulletWorld::readVelocities(std::vector<Vec3>& velocities_m_s) const {
  std::size_t vertex = 0;
  for (const auto& body : bodies_) {
    for (int i = 0; i < body->m_nodes.size(); ++i)
      velocities_m_s[vertex++] = fromBullet(body->m_nodes[i].m_v);
  }
}

void BulletWorld::scaleVelocities(double factor) {
  for (const auto& body : bodies_) {
    for (int i = 0; i < body->m_nodes.size(); ++i) body->m_nodes[i].m_v *= static_cast<btScalar>(factor);
  }
}

void BulletWorld::writePositions(const std::vector<Vec3>& positions_m) {
  std::size_t vertex = 0;
  for (const auto& body : bodies_) {
    for (int i = 0; i < body->m_nodes.size(); ++i) body->m_nodes[i].m_x = toBullet(positions_m[vertex++]);
  }
}

void BulletWorld::addMotion(std::span<const Vec3> motion_m) {
  std::size_t vertex = 0;
  for (const auto& body : bodies_) {
    const btScalar kept_per_s = body->m_sst.isdt * (1 - body->m_cfg.kDP);
    for (int i = 0; i < body->m_nodes.size(); ++i) {
      body->m_nodes[i].m_v += toBullet(motion_m[vertex++]) * kept_per_s;
    }
  }
}

std::vector<double> BulletWorld::inverseMasses() const {
  std::vector<double> inverse_masses;
  for (const auto& body : bodies_) {
    for (int i = 0; i < body->m_nodes.size(); ++i) inverse_masses.push_back(body->m_nodes[i].m_im);
  }
  return inverse_masses;
}

}  // namespace fissure
