#include "contact/swept_pairs.h"

#include <algorithm>

namespace fissure {

SweptPairs::SweptPairs(const SceneTool& tool, const SceneBody& body)
    : tool_(tool.surface, false),
      body_(body.rest, true),
      closed_tool_(tool.closed),
      corners_m_(tool.surface.vertices_m),
      tree_(corners_m_, tool.surface.faces),
      beyond_(body.rest.vertices_m.size()),
      is_candidate_(body.rest.faces.size()) {
  candidates_.reserve(body.rest.faces.size());
  for (const Face& f : tool_.faces()) {
    const Vec3 &a = corners_m_[f[0]], &b = corners_m_[f[1]], &c = corners_m_[f[2]];
    face_boxes_.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
  }
  for (const SurfaceEdge& edge : tool_.edges()) {
    const Vec3 &a = corners_m_[edge.from], &b = corners_m_[edge.to];
    edge_boxes_.push_back({a.cwiseMin(b), a.cwiseMax(b)});
  }
  all_ = face_boxes_.front();
  for (const Box& box : face_boxes_) all_ = {all_.low.cwiseMin(box.low), all_.high.cwiseMax(box.high)};
}

void SweptPairs::gather(const TissuePath& path, double reach_m) {
  for (std::size_t v = 0; v < beyond_.size(); ++v) noteBeyond(path, reach_m, v);
  for (const int f : candidates_) is_candidate_[f] = 0;
  candidates_.clear();
  for (std::size_t f = 0; f < body_.faces().size(); ++f)
    if (!isBeyond(body_.faces()[f])) addCandidate(static_cast<int>(f));
  collect(path, reach_m);
}

void SweptPairs::gather(const TissuePath& path, double reach_m, std::span<const int> moved) {
  for (const int v : moved) noteBeyond(path, reach_m, v);
  const std::size_t known = candidates_.size();
  for (const int v : moved)
    for (const int f : body_.facesAt(v))
      if (!is_candidate_[f]) addCandidate(f);
  if (candidates_.size() > known) std::sort(candidates_.begin(), candidates_.end());
  collect(path, reach_m);
}

bool SweptPairs::isBeyond(const Face& face) const {
  return (beyond_[face[0]] & beyond_[face[1]] & beyond_[face[2]]) != 0;
}

void SweptPairs::addCandidate(int face) {
  candidates_.push_back(face);
  is_candidate_[face] = 1;
}

void SweptPairs::noteBeyond(const TissuePath& path, double reach_m, std::size_t vertex) {
  const Vec3 &a = path.from_m[vertex], &b = path.to_m[vertex];
  unsigned sides = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = all_.low[axis] - reach_m, high = all_.high[axis] + reach_m;
    sides |= (a[axis] < low && b[axis] < low ? 1U : 0U) << 2 * axis;
    sides |= (a[axis] > high && b[axis] > high ? 2U : 0U) << 2 * axis;
  }
  beyond_[vertex] = static_cast<std::uint8_t>(sides);
}

void SweptPairs::collect(const TissuePath& path, double reach_m) {
  face_pairs_.clear();
  for (const int f : candidates_) {
    const Face& face = body_.faces()[f];
    if (isBeyond(face)) continue;
    Box box{path.from_m[face[0]], path.from_m[face[0]]};
    for (const int v : face) {
      box.low = box.low.cwiseMin(path.from_m[v]).cwiseMin(path.to_m[v]);
      box.high = box.high.cwiseMax(path.from_m[v]).cwiseMax(path.to_m[v]);
    }
    box = widened(box, reach_m);
    near_faces_.clear();
    tree_.nearBox(box.low, box.high, near_faces_);
    for (const int of_tool : near_faces_)
      if (meet(box, face_boxes_[of_tool])) face_pairs_.push_back({f, of_tool});
  }
}

}  // namespace fissure
