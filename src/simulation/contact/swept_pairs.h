#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/face_tree.h"
#include "contact/surface_features.h"

namespace fissure {

/// The features of a pair, that of the tissue first: face_corner is a corner of the tool at a face of the
/// tissue.
enum class PairKind : std::uint8_t {
  vertex_face,
  vertex_edge,
  vertex_corner,
  face_corner,
  edge_edge,
  edge_corner
};

/// A pair of features, tissue and tool, whose nearest points must stay apart; in the tool's frame.
struct SweptPair {
  PairKind kind = PairKind::vertex_face;
  int tissue = 0, tool = 0;  ///< indices of the two features in their surfaces
  Face vertices{};           ///< vertices of the body; for an edge or a vertex some repeat, with weight 0
  std::array<double, 3> weights{};  ///< barycentric coordinates of the tissue point
  Vec3 tool_point_m;
  Vec3 normal;      ///< unit, from the tool point to the tissue point
  double time = 0;  ///< share of the step after which they meet; 0: near when it began

  bool sameFeatures(const SweptPair& other) const {
    return kind == other.kind && tissue == other.tissue && tool == other.tool;
  }
};

/// Straight paths of a body's vertices in one step, in the frame of a tool, in which the tool rests. Views of
/// [vertex] arrays.
struct TissuePath {
  std::span<const Vec3> from_m, to_m;
};

/// Finds the pairs of features that must stay apart between the whole surface of one tool and that of one
/// body (contact/METHOD.md 8), in an order that depends on meshes and positions alone.
class SweptPairs {
 public:
  SweptPairs(const SceneTool& tool, const SceneBody& body);

  /// Collects the pairs of faces whose bounding boxes come nearer than `reach_m` on the path. Both searches
  /// below look only among these, and so for no larger distances.
  void gather(const TissuePath& path, double reach_m);
  /// The same where only the `moved` vertices of the body have changed paths since the last call, whose reach
  /// was not smaller.
  void gather(const TissuePath& path, double reach_m, std::span<const int> moved);

  /// Appends every local minimum below `reach_m` of the distance between tissue and tool at the start of the
  /// path. Two conditions of a minimum are relaxed so that contacts change less from step to step: the
  /// direction from an edge or corner may deviate by up to 30 degrees from the range that its faces allow,
  /// because otherwise tissue that lies flat on a tool's rim gains and loses contacts by rounding; and for
  /// two edges it suffices that one face of the tissue's edge faces the tool.
  void findNear(const TissuePath& path, double reach_m, std::vector<SweptPair>& pairs) const;

  /// Appends every pair of features that comes nearer than `separation_m` on the path, or, where it starts
  /// nearer than that, approaches at all.
  void findCrossings(const TissuePath& path, double separation_m, std::vector<SweptPair>& pairs) const;

  /// Whether the tool and the tissue at positions `at_m` overlap: their surfaces cross, or one is inside the
  /// other.
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
  std::vector<Vec3> corners_m_;               ///< corners of the tool
  FaceTree tree_;                             ///< over the tool's faces
  std::vector<Box> face_boxes_, edge_boxes_;  ///< bounding boxes of the tool's faces and edges
  Box all_;                                   ///< bounding box of the tool
  void noteBeyond(const TissuePath& path, double reach_m, std::size_t vertex);
  bool isBeyond(const Face& face) const;
  void addCandidate(int face);
  void collect(const TissuePath& path, double reach_m);

  // Of the last gather:
  /// [vertex] a bit per side of the tool's box: the path stays beyond it.
  std::vector<std::uint8_t> beyond_;
  std::vector<int> candidates_;  ///< faces of the tissue that may come near the tool's box, ascending
  std::vector<std::uint8_t> is_candidate_;  ///< [face of the tissue] 1: it is one of these
  std::vector<int> near_faces_;             ///< faces of the tool near one face of the tissue
  std::vector<FacePair> face_pairs_;
};

}  // namespace fissure
