#pragma once

#include <memory>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/force_law.h"

namespace fissure {

/// The interaction force of the paper (section "The interaction force model"): for each soft triangle with at
/// least one vertex in a colliding state, x is the distance between its centroid now and its centroid at rest
/// (time zero of the bodies as placed, before settling), x' the rate of x from the vertex velocities; F(x,
/// x') acts along the triangle's contact normal; the total is the sum. A triangle without a contact of its
/// own takes the weighted mean normal of the contacts at its vertices.
class TriangleForces {
 public:
  TriangleForces(const Scene& scene, std::vector<std::unique_ptr<ForceLaw>> laws);

  /// Fills state.forces, one entry a law: forces ON THE TOOLS, newtons.
  void evaluate(const ContactPatch& patch, State& state) const;

 private:
  std::vector<Face> faces_;  ///< all bodies, vertex indices into State arrays
  std::vector<Vec3> rest_centroids_m_;
  std::vector<std::unique_ptr<ForceLaw>> laws_;
};

}  // namespace fissure
