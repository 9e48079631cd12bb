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

/// Bullet's soft-body solver with additions: pose matching of small bodies, contacts of the ground, and
/// stages of a pipeline before and after its solve. It uses the exact time step, where Bullet's world passes
/// on a float.
class StagedSoftBodySolver : public btDefaultSoftBodySolver {
 public:
  StagedSoftBodySolver(double step_s, Ground* ground) : step_s_(step_s), ground_(ground) {}
  /// Prepares the solve for a ground of the pipeline's own contacts (GroundPreview).
  void showGround(double height_m) { preview_.emplace(height_m); }
  /// Replaces Bullet's pose matching of a body (PoseMatching).
  void matchPose(btSoftBody& body) { matched_.emplace_back(body); }
  void setBeforeSolve(std::function<void()> stage) { before_solve_ = std::move(stage); }
  void setAfterSolve(std::function<void()> stage) { after_solve_ = std::move(stage); }
  void predictMotion(btScalar step_s) override;
  void solveConstraints(btScalar step_s) override;
  double predict_s = 0;  ///< wall time so far
  double solve_s = 0;    ///< wall time so far, with the ground but without the stages of pipelines

 private:
  double step_s_;
  Ground* ground_;  ///< null: Bullet has no ground
  std::optional<GroundPreview> preview_;
  std::vector<PoseMatching> matched_;
  std::function<void()> before_solve_;
  std::function<void()> after_solve_;
};

/// Bullet's world with a stop-watch on its collision detection, and a hook after it, because contacts of
/// clusters are gone at the end of the step.
class TimedWorld : public btSoftRigidDynamicsWorld {
 public:
  using btSoftRigidDynamicsWorld::btSoftRigidDynamicsWorld;
  void performDiscreteCollisionDetection() override;
  void setAfterDetection(std::function<void()> stage) { after_detection_ = std::move(stage); }
  double detection_us = 0;  ///< wall time in the last step
  double detection_s = 0;   ///< wall time so far

 private:
  std::function<void()> after_detection_;
};

/// The soft bodies of a scenario in a Bullet world, with Bullet's ground unless the pipeline has its own
/// contacts with the ground. Pipelines add their tools and stages to it.
class BulletWorld {
 public:
  /// `configuration` null: Bullet's own collision detection for soft bodies.
  BulletWorld(const Scenario& scenario, const PipelineSettings& pipeline, const Scene& scene,
              std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> configuration);
  ~BulletWorld();

  /// One step of the scenario's length.
  void step();
  /// Wall time of Bullet's own stages so far.
  std::vector<StageTime> stageTimes() const;

  TimedWorld& world() { return *world_; }
  StagedSoftBodySolver& solver() { return *solver_; }
  const std::vector<std::unique_ptr<btSoftBody>>& bodies() const { return bodies_; }

  /// Copy between Bullet's vertices and [vertex] arrays over all bodies, scene frame.
  void readPositions(std::vector<Vec3>& positions_m) const;
  void readVelocities(std::vector<Vec3>& velocities_m_s) const;
  void writePositions(const std::vector<Vec3>& positions_m);
  /// Adds `motion_m` over the step to the velocities ([vertex], scene frame), damped as Bullet damps its own.
  void addMotion(std::span<const Vec3> motion_m);
  void scaleVelocities(double factor);  ///< multiplies those of all vertices
  /// [vertex] 1/kg, 0: fixed.
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
