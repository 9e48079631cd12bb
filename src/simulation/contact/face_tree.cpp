#include "contact/face_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace fissure {

namespace {
constexpr int kFacesPerLeaf = 4;
constexpr int kMaxDepth = 64;  // median splits: 64 levels hold more faces than an int can count
}  // namespace

FaceTree::FaceTree(std::span<const Vec3> positions_m, const std::vector<Face>& faces)
    : faces_(faces), order_(faces.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!faces_.empty()) build(positions_m, 0, static_cast<int>(faces_.size()));
}

int FaceTree::build(std::span<const Vec3> positions_m, int begin, int end) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back({boxOf(begin, end - begin, positions_m), begin, end - begin});
  if (end - begin <= kFacesPerLeaf) return index;

  const auto centroid = [&](int face, int axis) {
    const Face& f = faces_[face];
    return positions_m[f[0]][axis] + positions_m[f[1]][axis] + positions_m[f[2]][axis];
  };
  int axis = 0;
  (nodes_[index].box.high - nodes_[index].box.low).maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
    const double ca = centroid(a, axis), cb = centroid(b, axis);
    return ca < cb || (ca == cb && a < b);
  });
  build(positions_m, begin, middle);
  const int right = build(positions_m, middle, end);
  nodes_[index].first = right;
  nodes_[index].count = 0;
  return index;
}

FaceTree::Box FaceTree::boxOf(int first, int count, std::span<const Vec3> positions_m) const {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Box box{Vec3::Constant(inf), Vec3::Constant(-inf)};
  for (int i = first; i < first + count; ++i) {
    for (const int vertex : faces_[order_[i]]) {
      box.low = box.low.cwiseMin(positions_m[vertex]);
      box.high = box.high.cwiseMax(positions_m[vertex]);
    }
  }
  return box;
}

void FaceTree::refit(std::span<const Vec3> positions_m) {
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {  // children stand behind their parents
    Node& node = nodes_[i];
    if (node.count > 0) {
      node.box = boxOf(node.first, node.count, positions_m);
    } else {
      const Box& left = nodes_[i + 1].box;
      const Box& right = nodes_[node.first].box;
      node.box = {left.low.cwiseMin(right.low), left.high.cwiseMax(right.high)};
    }
  }
}

void FaceTree::nearBox(const Vec3& low, const Vec3& high, std::vector<int>& faces) const {
  std::array<int, 2 * kMaxDepth> stack{};
  int depth = 0;
  if (!nodes_.empty()) stack[depth++] = 0;
  while (depth > 0) {
    const int index = stack[--depth];
    const Node& node = nodes_[index];
    if ((node.box.low.array() > high.array()).any() || (node.box.high.array() < low.array()).any()) continue;
    if (node.count > 0) {
      faces.insert(faces.end(), order_.begin() + node.first, order_.begin() + node.first + node.count);
    } else {
      stack[depth++] = node.first;
      stack[depth++] = index + 1;
    }
  }
}

bool FaceTree::boxHolds(const Vec3& point_m) const {
  return !nodes_.empty() && (point_m.array() >= nodes_.front().box.low.array()).all() &&
         (point_m.array() <= nodes_.front().box.high.array()).all();
}

// Where the ray enters the box, 0 when it starts inside; infinity when it misses it. The box is widened by
// far more than the rounding of the triangle test, so that no hit on its border is lost.
double FaceTree::entryDistance(const Box& box, const Ray& ray) {
  constexpr double kPad_m = 1e-9;
  double near = 0, far = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] - kPad_m - ray.origin()[axis];
    const double high = box.high[axis] + kPad_m - ray.origin()[axis];
    const double inverse = ray.inverseDirection()[axis];
    if (std::isinf(inverse)) {
      if (low > 0 || high < 0) return std::numeric_limits<double>::infinity();
      continue;
    }
    const double t0 = low * inverse, t1 = high * inverse;
    near = std::max(near, std::min(t0, t1));
    far = std::min(far, std::max(t0, t1));
  }
  return near <= far ? near : std::numeric_limits<double>::infinity();
}

// Nearer child first, so that an early hit spares the rest.
std::optional<SurfaceHit> FaceTree::firstHit(const Ray& ray, std::span<const Vec3> positions_m,
                                             long long& tests) const {
  struct Pending {
    int node;
    double entry_m;
  };
  std::optional<SurfaceHit> best;
  if (nodes_.empty()) return best;
  constexpr double kSlack_m = 1e-9;  // entry distances are those of widened boxes
  double limit_m = ray.maxDistance();
  std::array<Pending, 2 * kMaxDepth> stack{};
  int depth = 0;
  stack[depth++] = {0, entryDistance(nodes_.front().box, ray)};
  while (depth > 0) {
    const Pending pending = stack[--depth];
    if (!(pending.entry_m <= limit_m + kSlack_m)) continue;
    const Node& node = nodes_[pending.node];
    if (node.count == 0) {
      const Pending left{pending.node + 1, entryDistance(nodes_[pending.node + 1].box, ray)};
      const Pending right{node.first, entryDistance(nodes_[node.first].box, ray)};
      const bool left_first = left.entry_m <= right.entry_m;
      stack[depth++] = left_first ? right : left;
      stack[depth++] = left_first ? left : right;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int face = order_[i];
      const Face& f = faces_[face];
      ++tests;
      const auto hit = ray.intersect(positions_m[f[0]], positions_m[f[1]], positions_m[f[2]]);
      if (!hit) continue;
      if (best && (hit->distance_m > best->at.distance_m ||
                   (hit->distance_m == best->at.distance_m && face > best->face)))
        continue;
      best = SurfaceHit{face, *hit};
      limit_m = hit->distance_m;
    }
  }
  return best;
}

}  // namespace fissure
