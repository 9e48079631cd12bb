#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <memory>
#include <vector>

#include "base/scene.h"
#include "base/stage_times.h"
#include "engine/deformable_body.h"
#include "engine/kinematic_tools.h"
#include "scenario/scenario.h"

namespace fissure {

/// Bullet's dispatcher with a stop-watch on collision detection.
class TimedDispatcher : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;
  double detection_s = 0;  ///< wall time so far
};

/// Bullet's solver of tetrahedra with the settings of a scenario, for most of which Bullet has no function,
/// and with a stop-watch on its stages.
class TimedDeformableSolver : public btDeformableBodySolver {
 public:
  explicit TimedDeformableSolver(const DeformableSolver& settings);
  void predictMotion(btScalar step_s) override;
  void solveDeformableConstraints(btScalar step_s) override;
  double predict_s = 0;  ///< wall time so far
  double solve_s = 0;    ///< wall time of the elements so far
};

/// Bullet's btDeformableMultiBodyDynamicsWorld with the one elastic body of a scenario, its tools as
/// kinematic bodies, and its ground as the upper face of a static box (engine/METHOD.md 5).
class DeformableWorld {
 public:
  DeformableWorld(const Scenario& scenario, const PipelineSettings& pipeline, const Scene& scene,
                  const std::vector<Pose>& first_poses);
  ~DeformableWorld();

  /// One step of Bullet, at whose end the tools have the poses `tools`; Bullet tests kinematic bodies for
  /// contact at these poses.
  void step(const std::vector<ToolState>& tools, double step_s);

  btSoftBody& body() { return *body_.body; }
  const std::vector<int>& nodeOfVertex() const { return body_.node_of_vertex; }
  btDeformableLagrangianForce& elasticity() { return *elasticity_; }
  const btDeformableContactProjection& contacts() const { return solver_->m_objective->m_projection; }
  bool isGround(const btCollisionObject* object) const { return object == ground_.get(); }
  const KinematicTools& tools() const { return *tools_; }
  /// Wall time of collision detection so far.
  double detection_s() const { return dispatcher_->detection_s; }
  std::vector<StageTime> stageTimes() const;

 private:
  void addGround(const GroundSettings& ground);

  std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> configuration_;
  std::unique_ptr<TimedDispatcher> dispatcher_;
  std::unique_ptr<btDbvtBroadphase> broadphase_;
  std::unique_ptr<TimedDeformableSolver> solver_;
  std::unique_ptr<btDeformableMultiBodyConstraintSolver> constraint_solver_;
  std::unique_ptr<btDeformableMultiBodyDynamicsWorld> world_;
  DeformableBody body_;
  std::unique_ptr<btDeformableLagrangianForce> elasticity_;
  std::unique_ptr<btDeformableGravityForce> gravity_;
  std::unique_ptr<btBoxShape> ground_shape_;
  std::unique_ptr<btRigidBody> ground_;
  std::unique_ptr<KinematicTools> tools_;
  double total_s_ = 0;  ///< wall time of Bullet's whole steps so far
};

}  // namespace fissure
