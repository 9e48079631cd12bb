#pragma once

#include <array>
#include <span>

#include "base/geometry.h"
#include "base/tool_nodes.h"

namespace fissure {

/// ContactConstraint::tool of a contact with the ground, which rests.
inline constexpr int kGround = -1;

/// Something that keeps a point of the tissue in front of a point of a tool, or of the ground: `normal`
/// points from there into the tissue.
struct ContactConstraint {
  Face vertices{};                  ///< of a soft triangle, indices over all bodies
  std::array<double, 3> weights{};  ///< barycentric coordinates of the tissue point, sum 1
  Vec3 position_m;                  ///< of the tool point, scene frame, end of the step
  Vec3 normal;                      ///< unit, scene frame
  int tool = 0;                     ///< whose point it is; kGround: the ground's
  double target_m = 0;  ///< least distance of the tissue point in front of the tool point, along normal
  double friction = 0;  ///< Coulomb's coefficient of tissue on tool; only ContactImpulses rubs
};

/// How many of the corners a point of a triangle takes part in: one for a vertex, whose weight comes first.
inline int cornersOf(const std::array<double, 3>& weights) {
  return weights[0] == 1 ? 1 : 3;
}

/// The point with barycentric coordinates `weights` in a triangle: of positions, or of ways of the vertices.
inline Vec3 pointOf(const Face& vertices, const std::array<double, 3>& weights,
                    std::span<const Vec3> of_vertices) {
  Vec3 point = Vec3::Zero();
  for (int j = 0; j < cornersOf(weights); ++j) point += weights[j] * of_vertices[vertices[j]];
  return point;
}

/// The tissue point of a contact.
inline Vec3 pointOf(const ContactConstraint& contact, std::span<const Vec3> of_vertices) {
  return pointOf(contact.vertices, contact.weights, of_vertices);
}

/// A contact that a tool node's ray proposes (step one of the method) and node association judges (step two).
struct NodeCandidate {
  int node = 0;  ///< index over all tools
  int body = 0;
  int face = 0;  ///< of that body
  ContactConstraint constraint;
  double depth_m = 0;     ///< from the node back to the tissue surface behind it, along -normal
  double approach_m = 0;  ///< of node and tissue surface along the normal, in the step
  NodeState state = NodeState::feasible;
};

/// What displacing tissue took so far.
struct DisplacementCounts {
  long long sweeps = 0;  ///< over the contacts of a step, where there were any
  long long pushes = 0;  ///< of a contact in a sweep, where it moved its tissue
};

}  // namespace fissure
