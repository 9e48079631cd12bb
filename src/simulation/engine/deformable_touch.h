#pragma once

#include <span>
#include <vector>

#include "base/state.h"
#include "contact/contact_patch.h"
#include "engine/deformable_world.h"

namespace fissure {

/// What one step of Bullet's deformable world gave the surface vertices, one each.
struct TouchedSurface {
  std::span<const Vec3> positions_m;   ///< at its end
  std::span<const Vec3> impulses_N_s;  ///< of contacts, where there are any
};

/// Who touched whom in a step of Bullet's deformable world, and how contacts share what the vertices got: the
/// obstacles of a vertex by the number of its contacts with each.
class DeformableTouch {
 public:
  /// Vertices of the scene, its tools, and the ground where there is one.
  DeformableTouch(DeformableWorld& world, const Scene& scene);

  /// The contacts of the last step, into `patch` those that bear.
  void read(ContactPatch& patch);
  int candidates() const { return candidates_; }  ///< contacts that Bullet's detection found
  int bearing() const { return bearing_; }        ///< of these, with an impulse
  /// Whether the vertex belongs to a contact, bearing or not: Bullet's solve holds it by either.
  bool touches(std::size_t vertex) const { return contacts_[vertex] > 0; }

  /// Adds forces on tools and ground and the tools' work in the step to `outcome`.
  void addForces(const TouchedSurface& surface, const std::vector<ToolState>& tools, double step_s,
                 ContactOutcome& outcome) const;

 private:
  struct Obstacle {
    int tool = 0;               ///< -1: the ground
    std::vector<int> contacts;  ///< per vertex
  };

  void touch(Obstacle& obstacle, const btSoftBody::Node* node);
  Obstacle& obstacleOf(const btCollisionObject* object);

  DeformableWorld& world_;
  std::vector<int> vertex_of_node_;  ///< -1: inside
  std::vector<Obstacle> obstacles_;  ///< the tools, then the ground
  std::vector<int> contacts_;        ///< per vertex, of all obstacles
  int candidates_ = 0, bearing_ = 0;
};

}  // namespace fissure
