#include "engine/ground_preview.h"

#include <algorithm>

namespace fissure {

void GroundPreview::lift(btAlignedObjectArray<btSoftBody*>& bodies) {
  const btScalar height_m = static_cast<btScalar>(height_m_);
  lifts_m_.clear();
  for (int b = 0; b < bodies.size(); ++b)
    for (int i = 0; i < bodies[b]->m_nodes.size(); ++i) {
      btSoftBody::Node& node = bodies[b]->m_nodes[i];
      const btScalar lift_m = node.m_im > 0 ? std::max(height_m - node.m_x.y(), btScalar(0)) : 0;
      node.m_x.setY(node.m_x.y() + lift_m);
      node.m_v.setY(node.m_v.y() + lift_m * bodies[b]->m_sst.isdt);  // velocity iterations start from it
      lifts_m_.push_back(lift_m);
    }
}

void GroundPreview::takeBack(btAlignedObjectArray<btSoftBody*>& bodies) const {
  std::size_t vertex = 0;
  for (int b = 0; b < bodies.size(); ++b) {
    const btScalar kept_per_s = bodies[b]->m_sst.isdt * (1 - bodies[b]->m_cfg.kDP);
    for (int i = 0; i < bodies[b]->m_nodes.size(); ++i) {
      btSoftBody::Node& node = bodies[b]->m_nodes[i];
      const btScalar lift_m = lifts_m_[vertex++];
      node.m_x.setY(node.m_x.y() - lift_m);
      node.m_v.setY(node.m_v.y() - lift_m * kept_per_s);
    }
  }
}

}  // namespace fissure
