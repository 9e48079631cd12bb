#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "surface/continuous_collision.h"
#include "surface/overlap.h"
#include "surface/surface_tree.h"

namespace fissure {

/// The reason why the end of a step is not proved free of overlap.
struct Objection {
  std::size_t body = 0, tool = 0;  ///< indices in the scene
  /// "vertex 12 of sphere may meet triangle 3 of spatula", "spatula may lie inside sphere"; indices of
  /// corners and triangles as in the surfaces of the scene.
  std::string what;
  double time = 0;  ///< share of the step, 0..1, until which they are proved apart; 1: found at its end
};

/// Proves step by step that no tool overlaps tissue (measure/METHOD.md 3), from positions and poses alone, in
/// the same way for every pipeline.
///
/// In a tool's own frame the tool rests, and each tissue vertex is assumed to move straight from its position
/// after the step before to its present one. If no triangle of the tissue meets one of the tool on this path
/// (earliestMeeting: no meeting is missed, and doubt counts as meeting), and the step before ended free of
/// overlap, then this one does too: surfaces do not cross, and no connected part of one encloses the other,
/// because winding numbers change only at crossings. (Where a part has folded over itself, a sheet and an
/// inverted one cancel: such a place is outside of it.) The initial state is tested as a whole, and so is
/// each step's end after one without proof: nothing is proved from such an end until this test finds no
/// overlap.
///
/// A proof covers motion between the ends of steps only along these straight paths. It does not cover tissue
/// against the ground or other tissue, nor the inside of a tool whose surface is open.
class Certifier {
 public:
  explicit Certifier(const Scene& scene);

  /// Takes the state of the next step, the initial one first. No value: its end is proved free of overlap,
  /// and so is the path to it, unless the step before ended in overlap.
  std::optional<Objection> certify(const State& state);

  /// Number of pairs of triangles tested for meeting since the start, a measure of cost.
  long long pairsAsked() const { return pairs_asked_; }

 private:
  struct Body {
    std::string name;
    std::vector<Face> faces;
    std::size_t first_vertex = 0;
    std::vector<SurfacePart> parts;
  };
  struct Tool {
    std::string name;
    TriangleMesh surface;
    bool closed = true;
    SurfaceTree tree;  ///< in the tool's frame, at rest
    std::vector<SurfacePart> parts;
  };
  /// A body in a tool's frame, metres, with [vertex] positions after the last two steps.
  struct Pair {
    std::size_t body = 0, tool = 0;
    std::vector<Vec3> before_m, now_m;
    bool is_free = false;     ///< the last step's end is proved free of overlap
    double separation_m = 0;  ///< more than the rounding of coordinates in this frame
  };
  /// Two primitives that may meet on their path.
  struct Encounter {
    std::string what;
    double time = std::numeric_limits<double>::infinity();
  };

  static bool moveTo(const State& state, const Body& body, Pair& pair);
  std::optional<Objection> followPaths(const Pair& pair);
  std::optional<Objection> testOverlap(const Pair& pair);
  /// Calls `visit(face of the body, face of the tool, time)` for all pairs of triangles that may meet while
  /// the body's vertices go from `from_m` to the pair's present ones, until it returns false; `time` as
  /// earliestMeeting gives it.
  template <class Visit>
  void forNearTriangles(const Pair& pair, const std::vector<Vec3>& from_m, const Visit& visit);
  void refine(const Pair& pair, const Face& of_body, const Face& of_tool, Encounter& earliest) const;

  std::vector<Body> bodies_;
  std::vector<Tool> tools_;
  std::vector<Pair> pairs_;
  long long pairs_asked_ = 0;
};

}  // namespace fissure
