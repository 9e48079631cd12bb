#include "contact/closest_points.h"
#include "contact/swept_pairs.h"

namespace fissure {

namespace {

constexpr double kTolerance = 1e-9;  ///< of shares of an edge, and of cosines
constexpr double kLean = 0.5;        ///< sine: how far a direction that leads away may lean to the inside

bool isInterior(double share) {
  return share > kTolerance && share < 1 - kTolerance;
}

bool isInterior(const std::array<double, 3>& weights) {
  return weights[0] > 0 && weights[1] > 0 && weights[2] > 0;
}

/// Does the point of a face with these coordinates lie on one of the flat edges that count as its inside, and
/// `gap_m` straight above it?
bool isAboveFlatEdge(const std::array<double, 3>& weights, const FaceFeatures& features, const Vec3& gap_m,
                     const Vec3& normal) {
  int on_flat_edge = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights[i] > 0) continue;
    if (!features.flat[i]) return false;
    ++on_flat_edge;
  }
  return on_flat_edge == 1 && gap_m.cross(normal).norm() <= kTolerance * gap_m.norm() * normal.norm();
}

/// Does the direction lead away from both faces of an edge?
bool leavesEdge(const SurfaceFeatures& surface, std::span<const Vec3> points_m, const SurfaceEdge& edge,
                const Vec3& direction) {
  const Vec3 along = (points_m[edge.to] - points_m[edge.from]).normalized();
  for (int side = 0; side < 2; ++side) {
    if (edge.faces[side] < 0) continue;
    Vec3 inward = points_m[surface.opposite(edge, side)] - points_m[edge.from];
    inward -= inward.dot(along) * along;
    if (inward.dot(direction) > kLean * inward.norm() * direction.norm()) return false;
  }
  return true;
}

/// Does it lead away from all edges of a corner?
bool leavesCorner(const SurfaceFeatures& surface, std::span<const Vec3> points_m, int corner,
                  const Vec3& direction) {
  for (const int other : surface.neighbours(corner)) {
    const Vec3 edge = points_m[other] - points_m[corner];
    if (edge.dot(direction) > kLean * edge.norm() * direction.norm()) return false;
  }
  return true;
}

/// Does a face beside an edge look in this direction? At a border one always does.
bool looksAlong(const SurfaceFeatures& surface, std::span<const Vec3> points_m, const SurfaceEdge& edge,
                const Vec3& direction) {
  for (const int face : edge.faces) {
    if (face < 0) return true;
    const Face& f = surface.faces()[face];
    const Vec3& a = points_m[f[0]];
    if ((points_m[f[1]] - a).cross(points_m[f[2]] - a).dot(direction) > 0) return true;
  }
  return false;
}

/// Share of an edge at which a point's foot stands on its line.
double footOn(const Vec3& from_m, const Vec3& to_m, const Vec3& point_m) {
  const Vec3 along = to_m - from_m;
  return (point_m - from_m).dot(along) / along.squaredNorm();
}

/// One search among features of both surfaces.
struct NearSearch {
  const SurfaceFeatures& tool;
  const SurfaceFeatures& body;
  std::span<const Vec3> corners_m;  ///< of the tool
  std::span<const Vec3> at_m;       ///< of the body
  double reach_m;
  std::vector<SweptPair>& pairs;

  /// Both points of the pair are known, but for its normal.
  void add(SweptPair pair) {
    Vec3 tissue_m = Vec3::Zero();
    for (int j = 0; j < 3; ++j) tissue_m += pair.weights[j] * at_m[pair.vertices[j]];
    const Vec3 gap_m = tissue_m - pair.tool_point_m;
    const double distance_m = gap_m.norm();
    if (!(distance_m < reach_m) || !(distance_m > 0)) return;
    pair.normal = gap_m / distance_m;
    pairs.push_back(pair);
  }

  void vertexOnFace(int v, int f) {
    const Face& face = tool.faces()[f];
    const Vec3 &a = corners_m[face[0]], &b = corners_m[face[1]], &c = corners_m[face[2]];
    const auto w = nearestOnTriangle(at_m[v], a, b, c);
    const Vec3 foot = w[0] * a + w[1] * b + w[2] * c;
    if (isInterior(w) || isAboveFlatEdge(w, tool.of(f), at_m[v] - foot, (b - a).cross(c - a)))
      add({PairKind::vertex_face, v, f, {v, v, v}, {1, 0, 0}, foot, {}});
  }
  void vertexOnEdge(int v, int e) {
    const SurfaceEdge& edge = tool.edges()[e];
    const Vec3 &from = corners_m[edge.from], &to = corners_m[edge.to];
    const double share = footOn(from, to, at_m[v]);
    if (!isInterior(share)) return;
    const Vec3 foot = from + share * (to - from);
    if (leavesEdge(tool, corners_m, edge, at_m[v] - foot))
      add({PairKind::vertex_edge, v, e, {v, v, v}, {1, 0, 0}, foot, {}});
  }
  void vertexOnCorner(int v, int corner) {
    const Vec3 gap_m = at_m[v] - corners_m[corner];
    if (gap_m.squaredNorm() < reach_m * reach_m && leavesCorner(tool, corners_m, corner, gap_m))
      add({PairKind::vertex_corner, v, corner, {v, v, v}, {1, 0, 0}, corners_m[corner], {}});
  }
  void faceOnCorner(int f, int corner) {
    const Face& face = body.faces()[f];
    const auto w = nearestOnTriangle(corners_m[corner], at_m[face[0]], at_m[face[1]], at_m[face[2]]);
    if (isInterior(w)) add({PairKind::face_corner, f, corner, face, w, corners_m[corner], {}});
  }
  void edgeOnEdge(int mine, int of_tool) {
    const SurfaceEdge &edge = body.edges()[mine], &other = tool.edges()[of_tool];
    const Vec3 &a = at_m[edge.from], &b = at_m[edge.to], &c = corners_m[other.from], &d = corners_m[other.to];
    const auto [s, t] = nearestOnSegments(a, b, c, d);
    if (!isInterior(s) || !isInterior(t)) return;
    const Vec3 tool_point = c + t * (d - c);
    const Vec3 gap_m = a + s * (b - a) - tool_point;
    if (gap_m.squaredNorm() >= reach_m * reach_m || !leavesEdge(tool, corners_m, other, gap_m) ||
        !looksAlong(body, at_m, edge, -gap_m))
      return;
    add({PairKind::edge_edge, mine, of_tool, {edge.from, edge.to, edge.to}, {1 - s, s, 0}, tool_point, {}});
  }
  void edgeOnCorner(int mine, int corner) {
    const SurfaceEdge& edge = body.edges()[mine];
    const Vec3 &a = at_m[edge.from], &b = at_m[edge.to], &p = corners_m[corner];
    const double s = footOn(a, b, p);
    if (!isInterior(s)) return;
    const Vec3 gap_m = a + s * (b - a) - p;
    if (gap_m.squaredNorm() < reach_m * reach_m && leavesEdge(body, at_m, edge, -gap_m))
      add({PairKind::edge_corner, mine, corner, {edge.from, edge.to, edge.to}, {1 - s, s, 0}, p, {}});
  }
};

bool nearer(const Vec3& point_m, const Vec3& low, const Vec3& high, double reach_m) {
  return (point_m.array() > low.array() - reach_m).all() && (point_m.array() < high.array() + reach_m).all();
}

}  // namespace

void SweptPairs::findNear(const TissuePath& path, double reach_m, std::vector<SweptPair>& pairs) const {
  const std::span<const Vec3> at_m = path.from_m;
  NearSearch search{tool_, body_, corners_m_, at_m, reach_m, pairs};
  for (const FacePair& pair : face_pairs_) {
    const FaceFeatures &mine = body_.of(pair.tissue), &others = tool_.of(pair.tool);
    const Box& box = face_boxes_[pair.tool];
    const Face& face = body_.faces()[pair.tissue];
    const Vec3 &a = at_m[face[0]], &b = at_m[face[1]], &c = at_m[face[2]];
    const Box own{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
    if (!meet(widened(own, reach_m), box)) continue;  // it comes near later
    for (const int v : mine.corners) {
      if (v < 0 || !nearer(at_m[v], box.low, box.high, reach_m)) continue;
      search.vertexOnFace(v, pair.tool);
      for (const int e : others.edges)
        if (e >= 0 && nearer(at_m[v], edge_boxes_[e].low, edge_boxes_[e].high, reach_m))
          search.vertexOnEdge(v, e);
      for (const int corner : others.corners)
        if (corner >= 0) search.vertexOnCorner(v, corner);
    }
    for (const int corner : others.corners) {
      if (corner < 0 || !nearer(corners_m_[corner], own.low, own.high, reach_m)) continue;
      search.faceOnCorner(pair.tissue, corner);
      for (const int e : mine.edges)
        if (e >= 0) search.edgeOnCorner(e, corner);
    }
    for (const int e : mine.edges) {
      if (e < 0) continue;
      const Vec3 &from = at_m[body_.edges()[e].from], &to = at_m[body_.edges()[e].to];
      const Box edge = widened({from.cwiseMin(to), from.cwiseMax(to)}, reach_m);
      for (const int of_tool : others.edges)
        if (of_tool >= 0 && meet(edge, edge_boxes_[of_tool])) search.edgeOnEdge(e, of_tool);
    }
  }
}

}  // namespace fissure
