#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/face_tree.h"
#include "contact/step_view.h"

namespace fissure {

/// Node ray casting (contact/METHOD.md 3): from a margin in front of each node a ray runs back into the tool
/// and out behind it. The first triangle of a body that it hits shows whether the ray starts inside that
/// body, and how far behind the node the tissue surface lies. A node that went right through a body and out
/// again in one step has no such triangle: then its path in the step, relative to the tissue, is cast, and
/// the surface through which it entered counts.
class NodeRays {
 public:
  /// margins_m: [body] distance at which contacts hold tissue in front of a node. ray_length_m: length of
  /// rays, at least the node's displacement in the step; no value: each body's extent at rest.
  NodeRays(const Scene& scene, std::vector<double> margins_m, std::optional<double> ray_length_m);

  /// Appends the candidates of one body to `candidates`.
  void cast(int body, const StepView& step, std::vector<NodeCandidate>& candidates);

  int bodyCount() const { return static_cast<int>(bodies_.size()); }
  int firstFace(int body) const { return bodies_[body].first_face; }
  /// Rays cast so far. A node outside of a body's bounding box needs none, except for its path where node and
  /// tissue moved by more than a margin relative to each other.
  long long rays() const { return rays_; }
  long long tests() const { return tests_; }  ///< ray-triangle tests so far

 private:
  /// The vertices of one body at the end of a step and when it began.
  struct Tissue {
    std::span<const Vec3> now_m, before_m;
  };
  struct Body {
    FaceTree tree;
    std::vector<Face> faces;
    int first_vertex = 0, first_face = 0, vertex_count = 0;
    double extent_m = 0;
    double margin_m = 0;
    Vec3 mean_travel_m = Vec3::Zero();  ///< mean displacement of the vertices in this step
    double largest_travel_m = 0;

    void noteTravel(const Tissue& tissue);
  };
  struct Node {
    int tool = 0;
    Vec3 position_m, normal;  ///< tool frame
    bool all_sides = false;   ///< ToolNodes::all_sides of its tool
  };

  /// The path of a node in this step, and its normal at the end, scene frame.
  struct Path {
    Vec3 from_m, to_m, normal;
  };

  std::optional<SurfaceHit> hitBehind(const Body& body, const Path& path, const Tissue& tissue);
  std::optional<SurfaceHit> hitOnPath(const Body& body, const Path& path, const Tissue& tissue);

  std::optional<double> ray_length_m_;
  std::vector<Body> bodies_;
  std::vector<Node> nodes_;
  long long rays_ = 0;
  long long tests_ = 0;
};

}  // namespace fissure
