#include "contact/swept_pairs.h"

namespace fissure {

SweptPairs::SweptPairs(const SceneTool& tool, const SceneBody& body)
    : tool_(tool.surface, false),
      body_(body.rest, true),
      closed_tool_(tool.closed),
      corners_m_(tool.surface.vertices_m),
      tree_(corners_m_, tool.surface.faces),
      beyond_(body.rest.vertices_m.size()) {
  for (const Face& f : tool_.faces()) {
    const Vec3 &a = corners_m_[f[0]], &b = corners_m_[f[1]], &c = corners_m_[f[2]];
    face_boxes_.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
  }
  all_ = face_boxes_.front();
  for (const Box& box : face_boxes_) all_ = {all_.low.cwiseMin(box.low), all_.high.cwiseMax(box.high)};
}

void SweptPairs::gather(const TissuePath& path, double reach_m) {
  face_pairs_.clear();
  const Vec3 low = all_.low.array() - reach_m, high = all_.high.array() + reach_m;
  for (std::size_t v = 0; v < beyond_.size(); ++v) {
    const Vec3 &a = path.from_m[v], &b = path.to_m[v];
    unsigned sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
      sides |= (a[axis] < low[axis] && b[axis] < low[axis] ? 1U : 0U) << 2 * axis;
      sides |= (a[axis] > high[axis] && b[axis] > high[axis] ? 2U : 0U) << 2 * axis;
    }
    beyond_[v] = static_cast<std::uint8_t>(sides);
  }
  for (std::size_t f = 0; f < body_.faces().size(); ++f) {
    const Face& face = body_.faces()[f];
    if (beyond_[face[0]] & beyond_[face[1]] & beyond_[face[2]]) continue;
    Box box{path.from_m[face[0]], path.from_m[face[0]]};
    for (const int v : face) {
      box.low = box.low.cwiseMin(path.from_m[v]).cwiseMin(path.to_m[v]);
      box.high = box.high.cwiseMax(path.from_m[v]).cwiseMax(path.to_m[v]);
    }
    box = {box.low.array() - reach_m, box.high.array() + reach_m};
    near_faces_.clear();
    tree_.nearBox(box.low, box.high, near_faces_);
    for (const int of_tool : near_faces_) {
      const Box& other = face_boxes_[of_tool];
      if ((other.low.array() <= box.high.array()).all() && (other.high.array() >= box.low.array()).all())
        face_pairs_.push_back({static_cast<int>(f), of_tool});
    }
  }
}

}  // namespace fissure
