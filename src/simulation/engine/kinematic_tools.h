#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <memory>
#include <vector>

#include "engine/pipeline.h"

namespace fissure {

/// The tools as kinematic rigid bodies of Bullet's world, for the pipelines with Bullet's own contact
/// (engine/METHOD.md 4). They are in the world as long as this object lives.
class KinematicTools {
 public:
  /// Box tools become Bullet's boxes, other tools convex hulls. Throws InputError for a tool that is not
  /// convex, or is open: Bullet's soft bodies would collide with its triangles as if they were 120 mm thick.
  KinematicTools(btDynamicsWorld& world, const Scenario& scenario, const Scene& scene,
                 const std::vector<Pose>& first_poses);
  explicit KinematicTools(const PipelineContext& context)
      : KinematicTools(context.world.world(), context.scenario, context.scene, context.first_poses) {}
  ~KinematicTools();
  KinematicTools(const KinematicTools&) = delete;
  KinematicTools& operator=(const KinematicTools&) = delete;

  /// Moves the tools to their poses at the step's end; to be called before Bullet's step.
  void move(const std::vector<ToolState>& now);
  /// Index of the tool that `object` is, or -1.
  int indexOf(const btCollisionObject* object) const;

 private:
  btDynamicsWorld& world_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace fissure
