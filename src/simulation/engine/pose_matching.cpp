#include "engine/pose_matching.h"

#include <LinearMath/btPolarDecomposition.h>

#include <algorithm>

namespace fissure {

namespace {

/// Sum over the vertices of weight (x - centre) X^T, where X is the place in the rest shape and x the vertex.
btMatrix3x3 scatter(const btSoftBody& body, const btVector3& centre) {
  btMatrix3x3 sum(0, 0, 0, 0, 0, 0, 0, 0, 0);
  for (int i = 0; i < body.m_nodes.size(); ++i) {
    const btVector3 arm = body.m_pose.m_wgh[i] * (body.m_nodes[i].m_x - centre);
    for (int row = 0; row < 3; ++row) sum[row] += arm[row] * body.m_pose.m_pos[i];
  }
  return sum;
}

btScalar largestRowSum(const btMatrix3x3& matrix) {
  btScalar largest = 0;
  for (int row = 0; row < 3; ++row) {
    const btVector3 sizes = matrix[row].absolute();
    largest = std::max(largest, sizes.x() + sizes.y() + sizes.z());
  }
  return largest;
}

}  // namespace

bool PoseMatching::isNeededFor(const btSoftBody& body) {
  if (!body.m_pose.m_bframe || body.m_cfg.kMT <= 0) return false;
  const btMatrix3x3 rest = scatter(body, body.m_pose.m_com);
  return largestRowSum(rest) * largestRowSum(rest.transpose()) < SIMD_EPSILON;
}

PoseMatching::PoseMatching(btSoftBody& body)
    : body_(&body), share_(body.m_cfg.kMT), scale_(1 / largestRowSum(scatter(body, body.m_pose.m_com))) {
  body.m_cfg.kMT = 0;
}

void PoseMatching::apply() const {
  const btVector3& centre = body_->m_pose.m_com;  // Bullet has found it in this step
  btMatrix3x3 rotation, stretch;
  polarDecompose(scatter(*body_, centre) * scale_, rotation, stretch);
  for (int i = 0; i < body_->m_nodes.size(); ++i) {
    btSoftBody::Node& node = body_->m_nodes[i];
    if (node.m_im > 0) node.m_x = lerp(node.m_x, rotation * body_->m_pose.m_pos[i] + centre, share_);
  }
}

}  // namespace fissure
