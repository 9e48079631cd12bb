#pragma once

#include <span>
#include <vector>

#include "base/state.h"
#include "contact/contact_patch.h"
#include "engine/deformable_world.h"

namespace fissure {

/// The result of a step of Bullet's deformable world for the surface vertices; [vertex] arrays, scene frame.
struct TouchedSurface {
  std::span<const Vec3> positions_m;   ///< at the end of the step
  std::span<const Vec3> impulses_N_s;  ///< impulse of contacts on the vertex; zero without contact
};

/// The contacts in a step of Bullet's deformable world. The impulse on a vertex is divided among its
/// obstacles, tools and ground, by the numbers of its contacts with them.
class DeformableTouch {
 public:
  /// For the vertices and tools of the scene, and the ground where there is one.
  DeformableTouch(DeformableWorld& world, const Scene& scene);

  /// Reads the contacts of the last step, and adds those with an impulse to `patch`.
  void read(ContactPatch& patch);
  int candidates() const { return candidates_; }  ///< contacts that Bullet's detection found
  int bearing() const { return bearing_; }        ///< contacts with an impulse
  /// Whether the vertex belongs to a contact, with an impulse or not: Bullet's solve holds it in both cases.
  bool touches(std::size_t vertex) const { return contacts_[vertex] > 0; }

  /// Adds the forces on tools and ground, and the work of the tools in the step, to `outcome`.
  void addForces(const TouchedSurface& surface, const std::vector<ToolState>& tools, double step_s,
                 ContactOutcome& outcome) const;

 private:
  struct Obstacle {
    int tool = 0;               ///< -1: the ground
    std::vector<int> contacts;  ///< [vertex] number of its contacts with this obstacle
  };

  void touch(Obstacle& obstacle, const btSoftBody::Node* node);
  Obstacle& obstacleOf(const btCollisionObject* object);

  DeformableWorld& world_;
  std::vector<int> vertex_of_node_;  ///< [node] -1: inside the body
  std::vector<Obstacle> obstacles_;  ///< the tools, then the ground
  std::vector<int> contacts_;        ///< [vertex] number of its contacts with all obstacles
  int candidates_ = 0, bearing_ = 0;
};

}  // namespace fissure
