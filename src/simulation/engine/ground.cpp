#include "engine/ground.h"

#include <BulletSoftBody/btSoftBodyInternals.h>

namespace fissure {

Ground::Ground(const GroundSettings& settings)
    : settings_(settings), plane_(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, nullptr)) {
  plane_.setFriction(static_cast<btScalar>(settings.friction));
}

void Ground::addContacts(btSoftBody& body) {
  const btVector3 up(0, 1, 0);
  const btScalar height = static_cast<btScalar>(settings_.height_m);
  const btScalar margin = body.getCollisionShape()->getMargin();
  const btScalar friction = body.m_cfg.kDF * plane_.getFriction();
  for (int i = 0; i < body.m_nodes.size(); ++i) {
    btSoftBody::Node& node = body.m_nodes[i];
    const btScalar distance = node.m_x.y() - height - margin;
    if (!(distance < 0) || !(node.m_im > 0)) continue;

    const btVector3 moved = node.m_x - node.m_q;
    const btScalar approach = btDot(moved, up);
    const btVector3 slip = moved - up * approach;
    btSoftBody::RContact contact;
    contact.t1 = contact.t2 = btVector3(0, 0, 0);  // tangents, only for multibodies
    contact.m_cti.m_colObj = &plane_;
    contact.m_cti.m_normal = up;
    contact.m_cti.m_offset = -btDot(up, node.m_x - up * distance);
    contact.m_node = &node;
    contact.m_c0 =
        ImpulseMatrix(body.m_sst.sdt, node.m_im, 0, btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0), node.m_x);
    contact.m_c1 = node.m_x;
    contact.m_c2 = node.m_im * body.m_sst.sdt;
    contact.m_c3 =
        slip.length2() < approach * friction * approach * friction ? 0 : 1 - friction;  // sticks : slides
    contact.m_c4 = static_cast<btScalar>(settings_.hardness);
    body.m_rcontacts.push_back(contact);
  }
}

}  // namespace fissure
