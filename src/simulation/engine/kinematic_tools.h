#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <memory>
#include <vector>

#include "engine/pipeline.h"

namespace fissure {

/// The tools as kinematic rigid bodies of Bullet's world, for the pipelines that use Bullet's own contact.
/// In the world for as long as this object lives.
class KinematicTools {
 public:
  /// Boxes as Bullet's boxes, other tools as their convex hulls. Throws InputError for a tool that is not
  /// convex, or open: Bullet's soft bodies meet it as triangles 120 mm thick.
  KinematicTools(btDynamicsWorld& world, const Scenario& scenario, const Scene& scene,
                 const std::vector<Pose>& first_poses);
  explicit KinematicTools(const PipelineContext& context)
      : KinematicTools(context.world.world(), context.scenario, context.scene, context.first_poses) {}
  ~KinematicTools();
  KinematicTools(const KinematicTools&) = delete;
  KinematicTools& operator=(const KinematicTools&) = delete;

  /// Before Bullet's step: to the poses at its end.
  void move(const std::vector<ToolState>& now);
  /// Which tool `object` is, or -1.
  int indexOf(const btCollisionObject* object) const;

 private:
  btDynamicsWorld& world_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace fissure
