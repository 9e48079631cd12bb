#include "engine/contact_trees.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace fissure {

namespace {

/// Things that are joined in pairs, and how many groups that leaves.
class Groups {
 public:
  explicit Groups(int things) : above_(static_cast<std::size_t>(things)), count_(things) {
    std::iota(above_.begin(), above_.end(), 0);
  }
  void join(int a, int b) {
    a = top(a);
    b = top(b);
    if (a == b) return;
    above_[static_cast<std::size_t>(a)] = b;
    --count_;
  }
  int count() const { return count_; }

 private:
  int top(int thing) {
    int& above = above_[static_cast<std::size_t>(thing)];
    while (above != thing) {
      thing = above;
      above = above_[static_cast<std::size_t>(above)];
    }
    return thing;
  }

  std::vector<int> above_;
  int count_;
};

int indexOf(const btSoftBody& body, const btSoftBody::Node* node) {
  return static_cast<int>(node - &body.m_nodes[0]);
}

int groupsOfVertices(const btSoftBody& body) {
  Groups groups(body.m_nodes.size());
  for (int i = 0; i < body.m_links.size(); ++i)
    groups.join(indexOf(body, body.m_links[i].m_n[0]), indexOf(body, body.m_links[i].m_n[1]));
  return groups.count();
}

int groupsOfTriangles(const btSoftBody& body) {
  Groups groups(body.m_faces.size());
  std::map<std::pair<int, int>, int> first_with;
  for (int i = 0; i < body.m_faces.size(); ++i) {
    for (int side = 0; side < 3; ++side) {
      const std::pair<int, int> edge = std::minmax(
          {indexOf(body, body.m_faces[i].m_n[side]), indexOf(body, body.m_faces[i].m_n[(side + 1) % 3])});
      groups.join(first_with.emplace(edge, i).first->second, i);
    }
  }
  return groups.count();
}

}  // namespace

void makeTreesOfPieces(btSoftBody& body) {
  if (!(body.m_cfg.collisions & btSoftBody::fCollision::VF_SS)) return;
  if (groupsOfVertices(body) == 1 && groupsOfTriangles(body) == 1) return;
  // What Bullet does before its first step, without its trees.
  body.updateConstants();
  body.m_bUpdateRtCst = false;
  for (int i = 0; i < body.m_faces.size(); ++i) {
    btSoftBody::Face& face = body.m_faces[i];
    const std::array<btVector3, 3> corners = {face.m_n[0]->m_x, face.m_n[1]->m_x, face.m_n[2]->m_x};
    face.m_leaf = body.m_fdbvt.insert(btDbvtVolume::FromPoints(corners.data(), 3), &face);
  }
}

}  // namespace fissure
