#include "contact/closest_points.h"
#include "contact/swept_pairs.h"

namespace fissure {

namespace {

/// One search for features that meet on a path, by conservative advancement (additive CCD: Li and others,
/// 2021): in a share of the step in which nothing goes farther than the two features are apart, they cannot
/// meet.
struct CrossingSearch {
  const SurfaceFeatures& tool;
  const SurfaceFeatures& body;
  std::span<const Vec3> corners_m;  ///< of the tool
  TissuePath path;
  double separation_m;
  std::vector<SweptPair>& pairs;

  Vec3 at(int vertex, double time) const {
    return path.from_m[vertex] + time * (path.to_m[vertex] - path.from_m[vertex]);
  }
  double way_m(int vertex) const { return (path.to_m[vertex] - path.from_m[vertex]).norm(); }

  /// `nearest(time, pair)` sets the points of a pair where its features are nearest, and gives the tissue's.
  template <class Nearest>
  void advance(double way_m, SweptPair pair, const Nearest& nearest) {
    constexpr int kMostAdvances = 200;  // what is not parted by then counts as meeting
    constexpr double kKept = 1 - 1e-6;  // of a distance below the separation already
    const auto distance_m = [&] {
      pair.normal = nearest(pair.time, pair) - pair.tool_point_m;
      const double length_m = pair.normal.norm();
      pair.normal /= length_m;
      return length_m;
    };
    double apart_m = distance_m();
    if (!(way_m > 0) || !(apart_m > 0) || apart_m > way_m + separation_m) return;
    const double least_m = std::min(separation_m, kKept * apart_m);
    const double enough_m = least_m + 0.1 * (std::min(apart_m, 10 * separation_m) - least_m);
    for (int i = 0; i < kMostAdvances; ++i) {
      pair.time += 0.9 * (apart_m - least_m) / way_m;
      if (pair.time > 1) return;
      apart_m = distance_m();
      if (apart_m < enough_m) break;
    }
    if (apart_m > 0) pairs.push_back(pair);
  }

  void vertexOnFace(int v, int f) {
    const Face& face = tool.faces()[f];
    const Vec3 &a = corners_m[face[0]], &b = corners_m[face[1]], &c = corners_m[face[2]];
    advance(way_m(v), {PairKind::vertex_face, v, f, {v, v, v}, {1, 0, 0}, {}, {}},
            [&](double time, SweptPair& pair) {
              const Vec3 point = at(v, time);
              const auto w = nearestOnTriangle(point, a, b, c);
              pair.tool_point_m = w[0] * a + w[1] * b + w[2] * c;
              return point;
            });
  }
  void faceOnCorner(int f, int corner) {
    const Face& face = body.faces()[f];
    const double way = std::max({way_m(face[0]), way_m(face[1]), way_m(face[2])});
    advance(way, {PairKind::face_corner, f, corner, face, {}, corners_m[corner], {}},
            [&](double time, SweptPair& pair) {
              const Vec3 a = at(face[0], time), b = at(face[1], time), c = at(face[2], time);
              pair.weights = nearestOnTriangle(pair.tool_point_m, a, b, c);
              return Vec3(pair.weights[0] * a + pair.weights[1] * b + pair.weights[2] * c);
            });
  }
  void edgeOnEdge(int mine, int of_tool) {
    const SurfaceEdge &edge = body.edges()[mine], &other = tool.edges()[of_tool];
    const Vec3 &c = corners_m[other.from], &d = corners_m[other.to];
    advance(std::max(way_m(edge.from), way_m(edge.to)),
            {PairKind::edge_edge, mine, of_tool, {edge.from, edge.to, edge.to}, {}, {}, {}},
            [&](double time, SweptPair& pair) {
              const Vec3 a = at(edge.from, time), b = at(edge.to, time);
              const auto [s, t] = nearestOnSegments(a, b, c, d);
              pair.weights = {1 - s, s, 0};
              pair.tool_point_m = c + t * (d - c);
              return Vec3(a + s * (b - a));
            });
  }
};

}  // namespace

void SweptPairs::findCrossings(const TissuePath& path, double separation_m,
                               std::vector<SweptPair>& pairs) const {
  CrossingSearch search{tool_, body_, corners_m_, path, separation_m, pairs};
  /// Round these vertices on their path, as wide as the separation.
  const auto boxOf = [&](std::initializer_list<int> vertices) {
    Vec3 low = path.from_m[*vertices.begin()], high = low;
    for (const int v : vertices) {
      low = low.cwiseMin(path.from_m[v]).cwiseMin(path.to_m[v]);
      high = high.cwiseMax(path.from_m[v]).cwiseMax(path.to_m[v]);
    }
    return widened({low, high}, separation_m);
  };
  for (const FacePair& pair : face_pairs_) {
    const FaceFeatures &mine = body_.of(pair.tissue), &others = tool_.of(pair.tool);
    const Box& box = face_boxes_[pair.tool];
    for (const int v : mine.corners)
      if (v >= 0 && meet(boxOf({v}), box)) search.vertexOnFace(v, pair.tool);
    const Face& face = body_.faces()[pair.tissue];
    for (const int corner : others.corners)
      if (corner >= 0 && meet(boxOf({face[0], face[1], face[2]}), {corners_m_[corner], corners_m_[corner]}))
        search.faceOnCorner(pair.tissue, corner);
    for (const int e : mine.edges) {
      if (e < 0) continue;
      const Box edge = boxOf({body_.edges()[e].from, body_.edges()[e].to});
      for (const int of_tool : others.edges)
        if (of_tool >= 0 && meet(edge, edge_boxes_[of_tool])) search.edgeOnEdge(e, of_tool);
    }
  }
}

}  // namespace fissure
