#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/scene.h"
#include "contact/contact_constraint.h"
#include "contact/face_tree.h"
#include "contact/step_view.h"

namespace fissure {

/// Step one of the method, node ray casting: from a margin in front of each node a ray runs back into the
/// tool and out behind it. The first triangle of a body that it meets tells whether it started inside that
/// body, and how far behind the node the tissue's surface lies (METHOD section 3). A node that went right
/// through and out again in one step has no such triangle: then its path in the step, relative to the
/// tissue's, is cast, and the surface it went in through counts.
class NodeRays {
 public:
  /// margins_m: one a body, how far in front of a node tissue is held. ray_length_m: no value: each body's
  /// extent at rest; never shorter than a node's travel in the step.
  NodeRays(const Scene& scene, std::vector<double> margins_m, std::optional<double> ray_length_m);

  /// Appends the candidates of one body to `candidates`.
  void cast(int body, const StepView& step, std::vector<NodeCandidate>& candidates);

  int bodyCount() const { return static_cast<int>(bodies_.size()); }
  int firstFace(int body) const { return bodies_[body].first_face; }
  /// Cast so far; a node outside the body's box needs none but for its path, and that only where node and
  /// tissue moved more than a margin.
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
    Vec3 mean_travel_m = Vec3::Zero();  ///< of the vertices in this step
    double largest_travel_m = 0;

    void noteTravel(const Tissue& tissue);
  };
  struct Node {
    int tool = 0;
    Vec3 position_m, normal;  ///< tool frame
    bool all_sides = false;   ///< the tool has nodes on all its sides
  };

  /// A node in this step, scene frame.
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
