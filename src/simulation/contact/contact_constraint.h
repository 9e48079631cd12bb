#pragma once

#include <array>
#include <span>

#include "base/geometry.h"
#include "base/tool_nodes.h"

namespace fissure {

/// The value of ContactConstraint::tool for a contact with the ground.
inline constexpr int kGround = -1;

/// A contact: a point of the tissue is kept in front of a point of a tool, or of the ground, from which
/// `normal` points into the tissue.
struct ContactConstraint {
  Face vertices{};                  ///< corners of a tissue triangle, indices over all bodies
  std::array<double, 3> weights{};  ///< barycentric coordinates of the tissue point, sum 1
  Vec3 position_m;                  ///< tool point at the end of the step, scene frame
  Vec3 normal;                      ///< unit, scene frame
  int tool = 0;                     ///< index of the tool, or kGround
  double target_m = 0;              ///< least distance of the tissue point from the tool point along `normal`
  double friction = 0;              ///< Coulomb's coefficient of tissue on tool, used by ContactImpulses only
};

/// Number of corners with a weight at a point of a triangle: 1 for a vertex, which comes first, else 3.
inline int cornersOf(const std::array<double, 3>& weights) {
  return weights[0] == 1 ? 1 : 3;
}

/// Interpolates positions or displacements of the vertices at the point of a triangle with barycentric
/// coordinates `weights`. `of_vertices` covers all bodies.
inline Vec3 pointOf(const Face& vertices, const std::array<double, 3>& weights,
                    std::span<const Vec3> of_vertices) {
  Vec3 point = Vec3::Zero();
  for (int j = 0; j < cornersOf(weights); ++j) point += weights[j] * of_vertices[vertices[j]];
  return point;
}

/// The same at the tissue point of a contact.
inline Vec3 pointOf(const ContactConstraint& contact, std::span<const Vec3> of_vertices) {
  return pointOf(contact.vertices, contact.weights, of_vertices);
}

/// A candidate contact, which the ray of a tool node proposes (contact/METHOD.md 3) and node association
/// accepts or excludes (contact/METHOD.md 4).
struct NodeCandidate {
  int node = 0;  ///< index over all tools
  int body = 0;
  int face = 0;  ///< index in that body
  ContactConstraint constraint;
  double depth_m = 0;     ///< distance from the node back to the tissue surface behind it, along -normal
  double approach_m = 0;  ///< approach of node and tissue surface along the normal in this step
  NodeState state = NodeState::feasible;
};

/// Counts of the displacement solver over the run so far.
struct DisplacementCounts {
  long long sweeps = 0;  ///< sweeps over the contacts of all steps
  long long pushes = 0;  ///< contacts that moved their tissue, counted in each sweep
};

}  // namespace fissure
