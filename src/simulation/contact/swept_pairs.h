#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/face_tree.h"
#include "contact/surface_features.h"

namespace fissure {

/// What of the tissue is near what of the tool, in this order: face_corner is a corner of the tool on a face
/// of the tissue.
enum class PairKind : std::uint8_t {
  vertex_face,
  vertex_edge,
  vertex_corner,
  face_corner,
  edge_edge,
  edge_corner
};

/// A point of the tissue and a point of a tool that must stay apart, in the tool's frame.
struct SweptPair {
  PairKind kind = PairKind::vertex_face;
  int tissue = 0, tool = 0;         ///< indices of the two features on their surfaces
  Face vertices{};                  ///< of the body; an edge or a vertex repeats one, with weight 0
  std::array<double, 3> weights{};  ///< barycentric coordinates of the tissue's point
  Vec3 tool_point_m;
  Vec3 normal;      ///< unit, from the tool's point to the tissue's
  double time = 0;  ///< share of the step at which they meet; 0: near when it began

  bool sameFeatures(const SweptPair& other) const {
    return kind == other.kind && tissue == other.tissue && tool == other.tool;
  }
};

/// The way of a body's vertices in one step, in the frame of a tool: straight, and the tool rests. Views.
struct TissuePath {
  std::span<const Vec3> from_m, to_m;
};

/// Finds what must stay apart between all of one tool's surface and all of one body's (METHOD section 9), in
/// an order that depends on meshes and positions alone.
class SweptPairs {
 public:
  SweptPairs(const SceneTool& tool, const SceneBody& body);

  /// Notes the pairs of faces whose boxes come nearer than `reach_m` on the path: both searches below look
  /// among the last ones noted, for no larger distance.
  void gather(const TissuePath& path, double reach_m);
  /// gather where only the `moved` vertices of the body have another path than at the last one, whose reach
  /// was no smaller.
  void gather(const TissuePath& path, double reach_m, std::span<const int> moved);

  /// Appends every local minimum below `reach_m` of the distance between tissue and tool at the path's start.
  /// So that contacts change less from step to step than strict minima, the direction from an edge or corner
  /// may lean by up to 30 degrees over what meets there: else tissue that lies flat on a tool's rim gains and
  /// loses contacts by rounding. And between edges it is enough that one face of the tissue's edge looks at
  /// the tool.
  void findNear(const TissuePath& path, double reach_m, std::vector<SweptPair>& pairs) const;

  /// Appends every pair of features that comes nearer than `separation_m` on the path, or, where it starts
  /// nearer than that, comes nearer at all.
  void findCrossings(const TissuePath& path, double separation_m, std::vector<SweptPair>& pairs) const;

  /// Whether tissue at `at_m` and the tool overlap: their surfaces cross, or one is inside the other.
  bool overlap(std::span<const Vec3> at_m);

  const SurfaceFeatures& tissue() const { return body_; }

 private:
  struct FacePair {
    int tissue = 0, tool = 0;
  };
  struct Box {
    Vec3 low, high;
  };
  static Box widened(const Box& box, double by_m) {
    return {box.low.array() - by_m, box.high.array() + by_m};
  }
  static bool meet(const Box& a, const Box& b) {
    return (a.low.array() <= b.high.array()).all() && (a.high.array() >= b.low.array()).all();
  }

  SurfaceFeatures tool_, body_;
  bool closed_tool_;
  std::vector<Vec3> corners_m_;               ///< of the tool
  FaceTree tree_;                             ///< over the tool's faces
  std::vector<Box> face_boxes_, edge_boxes_;  ///< of the tool's faces and edges
  Box all_;                                   ///< round the tool
  void noteBeyond(const TissuePath& path, double reach_m, std::size_t vertex);
  bool isBeyond(const Face& face) const;
  void addCandidate(int face);
  void collect(const TissuePath& path, double reach_m);

  // Of the last gather:
  std::vector<std::uint8_t> beyond_;  ///< per vertex, a bit for each side of the tool's box: it stays beyond
  std::vector<int> candidates_;       ///< faces of the tissue that may come near the tool's box, ascending
  std::vector<std::uint8_t> is_candidate_;  ///< per face of the tissue, 1: it is one of them
  std::vector<int> near_faces_;             ///< of the tool, for one face of the tissue
  std::vector<FacePair> face_pairs_;
};

}  // namespace fissure
