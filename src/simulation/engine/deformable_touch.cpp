#include "engine/deformable_touch.h"

#include <algorithm>

#include "engine/convert.h"

namespace fissure {

DeformableTouch::DeformableTouch(DeformableWorld& world, const Scene& scene)
    : world_(world), vertex_of_node_(world.nodeOfVertex().size(), -1), contacts_(scene.vertexCount()) {
  for (std::size_t v = 0; v < contacts_.size(); ++v)
    vertex_of_node_[world.nodeOfVertex()[v]] = static_cast<int>(v);
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    obstacles_.push_back({static_cast<int>(t), std::vector<int>(contacts_.size())});
  if (scene.ground_height_m) obstacles_.push_back({-1, std::vector<int>(contacts_.size())});
}

DeformableTouch::Obstacle& DeformableTouch::obstacleOf(const btCollisionObject* object) {
  const int tool = world_.tools().indexOf(object);
  return tool < 0 ? obstacles_.back() : obstacles_[tool];
}

void DeformableTouch::touch(Obstacle& obstacle, const btSoftBody::Node* node) {
  const int vertex = vertex_of_node_[node - &world_.body().m_nodes[0]];
  if (vertex < 0) return;
  ++obstacle.contacts[vertex];
  ++contacts_[vertex];
}

void DeformableTouch::read(ContactPatch& patch) {
  patch.clear();
  std::fill(contacts_.begin(), contacts_.end(), 0);
  for (Obstacle& obstacle : obstacles_) std::fill(obstacle.contacts.begin(), obstacle.contacts.end(), 0);
  candidates_ = bearing_ = 0;
  const btSoftBody& body = world_.body();
  const auto& nodes = world_.contacts().m_nodeRigidConstraints[0];
  for (int i = 0; i < nodes.size(); ++i) {
    Obstacle& obstacle = obstacleOf(nodes[i].m_contact->m_cti.m_colObj);
    touch(obstacle, nodes[i].m_node);
    if (obstacle.tool < 0) continue;
    ++candidates_;
    const int vertex = vertex_of_node_[nodes[i].m_node - &body.m_nodes[0]];
    if (!nodes[i].m_binding || vertex < 0) continue;
    ++bearing_;
    patch.touchVertex(obstacle.tool, vertex, 1, fromBullet(nodes[i].m_contact->m_cti.m_normal), 1);
  }
  const auto& faces = world_.contacts().m_faceRigidConstraints[0];
  for (int i = 0; i < faces.size(); ++i) {
    Obstacle& obstacle = obstacleOf(faces[i].m_contact->m_cti.m_colObj);
    const btSoftBody::Face* face = faces[i].m_face;
    for (const btSoftBody::Node* node : face->m_n) touch(obstacle, node);
    if (obstacle.tool < 0) continue;
    ++candidates_;
    if (!faces[i].m_binding) continue;
    ++bearing_;
    const Vec3 normal = fromBullet(faces[i].m_contact->m_cti.m_normal);
    for (int k = 0; k < 3; ++k) {
      const double weight = faces[i].getContact()->m_bary[k];
      if (weight > 0)
        patch.touchVertex(obstacle.tool, vertex_of_node_[face->m_n[k] - &body.m_nodes[0]], weight, normal, 1);
    }
    patch.touchFace(obstacle.tool, static_cast<int>(face - &body.m_faces[0]), normal, 1);
  }
}

void DeformableTouch::addForces(const TouchedSurface& surface, const std::vector<ToolState>& tools,
                                double step_s, ContactOutcome& outcome) const {
  for (const Obstacle& obstacle : obstacles_) {
    Vec3 impulse_N_s = Vec3::Zero();
    double work_J = 0;
    for (std::size_t v = 0; v < contacts_.size(); ++v) {
      if (obstacle.contacts[v] == 0) continue;
      const Vec3 given_N_s = surface.impulses_N_s[v] * obstacle.contacts[v] / contacts_[v];
      impulse_N_s += given_N_s;
      if (obstacle.tool < 0) continue;
      const ToolState& tool = tools[obstacle.tool];
      const Vec3 arm_m = surface.positions_m[v] - tool.pose.position_m;
      work_J += given_N_s.dot(tool.velocity_m_s + tool.angular_velocity_rad_s.cross(arm_m));
    }
    const Vec3 force_N = -impulse_N_s / step_s;
    if (obstacle.tool < 0) {
      *outcome.ground_reaction_N += force_N;
      continue;
    }
    outcome.reaction_on_tool_N += force_N;
    outcome.tool_work_J += work_J;
    if (!outcome.tool_reactions_N.empty()) outcome.tool_reactions_N[obstacle.tool] += force_N;
  }
}

}  // namespace fissure
