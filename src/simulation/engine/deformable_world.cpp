#include "engine/deformable_world.h"

#include "engine/collision_pools.h"
#include "engine/convert.h"

namespace fissure {

namespace {

/// Edge of the box that stands for the ground: Bullet's plane is concave, and no soft body meets it by faces.
constexpr double kGroundSize_m = 20;

void apply(const DeformableSolver& settings, btDeformableMultiBodyDynamicsWorld& world) {
  world.setImplicit(*settings.implicit);
  world.setLineSearch(*settings.line_search);
  world.setUseProjection(*settings.projection);
  btContactSolverInfo& contacts = world.getSolverInfo();
  contacts.m_numIterations = *settings.contact_iterations;
  contacts.m_leastSquaresResidualThreshold = static_cast<btScalar>(*settings.contact_tolerance);
  contacts.m_splitImpulse = *settings.split_impulse;
  contacts.m_deformable_erp = static_cast<btScalar>(*settings.error_reduction);
  contacts.m_deformable_maxErrorReduction = static_cast<btScalar>(*settings.max_error_reduction_m_s);
  contacts.m_deformable_cfm = static_cast<btScalar>(*settings.constraint_mixing);
}

}  // namespace

void TimedDispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                                btDispatcher* dispatcher) {
  StageClock clock;
  btCollisionDispatcher::dispatchAllCollisionPairs(pairs, info, dispatcher);
  clock.lap(detection_s);
}

TimedDeformableSolver::TimedDeformableSolver(const DeformableSolver& settings) {
  m_maxNewtonIterations = *settings.newton_iterations;
  m_newtonTolerance = static_cast<btScalar>(*settings.newton_tolerance);
  m_cg.m_maxIterations = m_cr.m_maxIterations = *settings.krylov_iterations;
  m_cg.m_tolerance = m_cr.m_tolerance = static_cast<btScalar>(*settings.krylov_tolerance);
}

void TimedDeformableSolver::predictMotion(btScalar step_s) {
  StageClock clock;
  btDeformableBodySolver::predictMotion(step_s);
  clock.lap(predict_s);
}

void TimedDeformableSolver::solveDeformableConstraints(btScalar step_s) {
  StageClock clock;
  btDeformableBodySolver::solveDeformableConstraints(step_s);
  clock.lap(solve_s);
}

DeformableWorld::DeformableWorld(const Scenario& scenario, const PipelineSettings& pipeline,
                                 const Scene& scene, const std::vector<Pose>& first_poses)
    : configuration_(std::make_unique<btSoftBodyRigidBodyCollisionConfiguration>(collisionPools())),
      dispatcher_(std::make_unique<TimedDispatcher>(configuration_.get())),
      broadphase_(std::make_unique<btDbvtBroadphase>()),
      constraint_solver_(std::make_unique<btDeformableMultiBodyConstraintSolver>()) {
  const BodySettings& body = scenario.bodies.at(0);
  const DeformableSolver settings = pipeline.deformableSolver(body.elastic.material);
  solver_ = std::make_unique<TimedDeformableSolver>(settings);
  constraint_solver_->setDeformableSolver(solver_.get());
  world_ = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
      dispatcher_.get(), broadphase_.get(), constraint_solver_.get(), configuration_.get(), solver_.get());
  apply(settings, *world_);
  const btVector3 gravity = toBullet(scenario.world.gravity_m_s2);
  world_->setGravity(gravity);
  btSoftBodyWorldInfo& info = world_->getWorldInfo();
  info.m_gravity = gravity;
  info.m_maxDisplacement = static_cast<btScalar>(scenario.world.max_displacement_m);
  info.m_sparsesdf.setDefaultVoxelsz(static_cast<btScalar>(pipeline.sdfVoxel_m()));
  info.m_sparsesdf.Reset();  // a new voxel size applies from here on
  body_ = makeDeformableBody(info, scene.bodies.at(0), body, pipeline);
  world_->addSoftBody(body_.body.get());
  elasticity_ = makeElasticity(body.elastic);
  gravity_ = std::make_unique<btDeformableGravityForce>(gravity);
  world_->addForce(body_.body.get(), elasticity_.get());
  world_->addForce(body_.body.get(), gravity_.get());
  if (scenario.ground) addGround(*scenario.ground);
  tools_ = std::make_unique<KinematicTools>(*world_, scenario, scene, first_poses);
}

DeformableWorld::~DeformableWorld() {
  tools_.reset();
  if (ground_) world_->removeRigidBody(ground_.get());
  world_->removeSoftBody(body_.body.get());
}

void DeformableWorld::addGround(const GroundSettings& ground) {
  const btScalar half_m = static_cast<btScalar>(kGroundSize_m / 2);
  ground_shape_ = std::make_unique<btBoxShape>(btVector3(half_m, half_m, half_m));
  btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, ground_shape_.get());
  info.m_startWorldTransform.setIdentity();
  info.m_startWorldTransform.setOrigin(
      btVector3(0, static_cast<btScalar>(ground.height_m - kGroundSize_m / 2), 0));
  info.m_friction = static_cast<btScalar>(ground.friction);
  ground_ = std::make_unique<btRigidBody>(info);
  world_->addRigidBody(ground_.get());
}

void DeformableWorld::step(const std::vector<ToolState>& tools, double step_s) {
  StageClock clock;
  tools_->move(tools);
  world_->stepSimulation(static_cast<btScalar>(step_s), 0);  // 0: one step of this length
  clock.lap(total_s_);
}

std::vector<StageTime> DeformableWorld::stageTimes() const {
  return {{"predict", solver_->predict_s},
          {"detection", detection_s()},
          {"contacts", total_s_ - solver_->predict_s - detection_s() - solver_->solve_s},
          {"solve", solver_->solve_s}};
}

}  // namespace fissure
