#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/face_tree.h"

namespace fissure {

/// A contact between a tool node and a triangle of a body.
struct NodeCandidate {
  int node = 0;  ///< index over all tools
  int body = 0;
  int face = 0;                     ///< of that body
  std::array<int, 3> vertices{};    ///< of the face, indices over all bodies
  std::array<double, 3> weights{};  ///< barycentric coordinates of the hit point
  Vec3 node_position_m;             ///< scene frame, end of the step
  Vec3 normal;                      ///< the node's, scene frame: out of the tool, into the tissue
  NodeState state = NodeState::feasible;
  double depth_m = 0;     ///< from the node back to the tissue surface behind it, along -normal
  double approach_m = 0;  ///< of node and tissue surface along the normal, in the step
  double target_m = 0;    ///< distance in front of the node to which the hit point is moved
};

struct NodeContactSettings {
  bool association = true;  ///< false: ray casting only, step one without step two (paper, Fig. 3 right)
  int sweeps = 10;          ///< Gauss-Seidel sweeps of enforced displacement
  std::optional<double>
      ray_length_m;                   ///< default: each body's extent, at least the node's travel in the step
  double max_displacement_m = 0.005;  ///< of tissue at a contact, beyond the approach of the step itself
  std::vector<double> margins_m;      ///< one a body: how far in front of a node the tissue is held
};

/// The collision method of the paper on plain arrays: node ray casting (step one), feasibility by node
/// association and the state of the previous step (step two), feasible enforced displacement. METHOD sections
/// 3 to 5. One object belongs to one run: it remembers which side of each node pair holds its contact.
class NodeContact {
 public:
  NodeContact(const Scene& scene, NodeContactSettings settings);

  /// One step, after the engine's own solve. `positions_m` are changed in place; `tools_before` are the tools
  /// at the start of the step, `tools_now` at its end. inverse_masses in 1/kg, 0: fixed. Fills node_states,
  /// the counts and reaction of `state`, and `patch`.
  void step(std::span<Vec3> positions_m, std::span<const double> inverse_masses,
            const std::vector<ToolState>& tools_before, const std::vector<ToolState>& tools_now, double dt_s,
            State& state, ContactPatch& patch);

  /// Ray-triangle tests so far, for benchmarks.
  long long rayTests() const { return ray_tests_; }
  long long rays() const { return rays_; }

 private:
  static constexpr std::int64_t kNotHeld = -1;

  struct Body {
    FaceTree tree;
    std::vector<Face> faces;
    int first_vertex = 0, first_face = 0, vertex_count = 0;
    double extent_m = 0;
    double margin_m = 0;
    std::vector<int> candidate_of_node;  ///< index into candidates_, -1: none
    std::vector<std::int64_t>
        held_since;  ///< per node: step since which its side holds the contact; kNotHeld
  };
  struct Node {
    int tool = 0;
    Vec3 position_m, normal;  ///< tool frame
    int partner = -1;         ///< index over all tools
    double thickness_m = 0;
    double travel_m = 0;  ///< in this step
  };

  void detect(std::span<const Vec3> positions_m, const std::vector<ToolState>& tools_before,
              const std::vector<ToolState>& tools_now);
  void associate(const std::vector<int>& candidates_of_body, Body& body);
  void remember(Body& body) const;
  void limitDisplacement(NodeCandidate& contact) const;
  void displace(std::span<Vec3> positions_m, std::span<const double> inverse_masses);
  void report(std::span<const Vec3> positions_m, std::span<const double> inverse_masses, double dt_s,
              State& state, ContactPatch& patch) const;

  NodeContactSettings settings_;
  std::vector<Body> bodies_;
  std::vector<Node> nodes_;
  std::vector<NodeCandidate> candidates_;
  std::vector<Vec3> before_step_m_;          ///< tissue at the start of the step: as the last step left it
  std::vector<Vec3> before_displacement_m_;  ///< of the touched vertices
  std::vector<int> touched_;
  std::vector<std::uint8_t> is_touched_;
  std::int64_t step_ = 0;
  long long ray_tests_ = 0;
  long long rays_ = 0;
};

}  // namespace fissure
