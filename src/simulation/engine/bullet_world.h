#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletSoftBody/btDefaultSoftBodySolver.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/scene.h"
#include "base/stage_times.h"
#include "engine/ground.h"
#include "engine/ground_preview.h"
#include "engine/pose_matching.h"
#include "scenario/scenario.h"

namespace fissure {

/// Bullet's soft-body solver with things of ours: the pose matching of small bodies, the ground's contacts
/// and a stage before its solve, and a stage after it. Steps with the exact time step, where Bullet's world
/// hands over a float.
class StagedSoftBodySolver : public btDefaultSoftBodySolver {
 public:
  StagedSoftBodySolver(double step_s, Ground* ground) : step_s_(step_s), ground_(ground) {}
  /// Of a ground that is none of Bullet's.
  void showGround(double height_m) { preview_.emplace(height_m); }
  void matchPose(btSoftBody& body) { matched_.emplace_back(body); }
  void setBeforeSolve(std::function<void()> stage) { before_solve_ = std::move(stage); }
  void setAfterSolve(std::function<void()> stage) { after_solve_ = std::move(stage); }
  void predictMotion(btScalar step_s) override;
  void solveConstraints(btScalar step_s) override;
  double predict_s = 0;  ///< wall time so far
  double solve_s = 0;    ///< wall time so far, without the stages of ours but the ground's

 private:
  double step_s_;
  Ground* ground_;  ///< null: no ground of Bullet's
  std::optional<GroundPreview> preview_;
  std::vector<PoseMatching> matched_;
  std::function<void()> before_solve_;
  std::function<void()> after_solve_;
};

/// Bullet's world with a stop-watch on its collision stage, and a look at what that stage found: contacts of
/// clusters are gone when the step ends.
class TimedWorld : public btSoftRigidDynamicsWorld {
 public:
  using btSoftRigidDynamicsWorld::btSoftRigidDynamicsWorld;
  void performDiscreteCollisionDetection() override;
  void setAfterDetection(std::function<void()> stage) { after_detection_ = std::move(stage); }
  double detection_us = 0;  ///< of the last step
  double detection_s = 0;   ///< so far

 private:
  std::function<void()> after_detection_;
};

/// The soft bodies of a scenario in a Bullet world, and its ground but where a pipeline has contacts of its
/// own with that. Pipelines add their tools and stages to it.
class BulletWorld {
 public:
  /// `configuration` null: Bullet's own collision detection for soft bodies.
  BulletWorld(const Scenario& scenario, const PipelineSettings& pipeline, const Scene& scene,
              std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> configuration);
  ~BulletWorld();

  void step();
  /// Of Bullet's own stages.
  std::vector<StageTime> stageTimes() const;

  TimedWorld& world() { return *world_; }
  StagedSoftBodySolver& solver() { return *solver_; }
  const std::vector<std::unique_ptr<btSoftBody>>& bodies() const { return bodies_; }

  /// Copies between Bullet's vertices and arrays over all bodies (sizes: the scene's vertex count).
  void readPositions(std::vector<Vec3>& positions_m) const;
  void readVelocities(std::vector<Vec3>& velocities_m_s) const;
  void writePositions(const std::vector<Vec3>& positions_m);
  /// Adds to each vertex's velocity what its displacement `motion_m` in the step amounts to, damped as Bullet
  /// damps its own.
  void addMotion(std::span<const Vec3> motion_m);
  std::vector<double> inverseMasses() const;

 private:
  double step_s_;
  std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  std::unique_ptr<btDbvtBroadphase> broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> rigid_solver_;
  std::unique_ptr<Ground> ground_;
  std::unique_ptr<StagedSoftBodySolver> solver_;
  std::unique_ptr<TimedWorld> world_;
  std::vector<std::unique_ptr<btSoftBody>> bodies_;
};

}  // namespace fissure
