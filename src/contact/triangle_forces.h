#pragma once

#include <memory>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/force_law.h"

namespace fissure {

/// Where x' comes from.
enum class RateSource {
  differences,  ///< the centroid's way since the last step, over dt
  velocities,   ///< the engine's vertex velocities
};

struct TriangleLaw {
  std::unique_ptr<ForceLaw> law;
  RateSource rate = RateSource::differences;
};

/// The interaction force of the paper (section "The interaction force model"): for each soft triangle with at
/// least one vertex in a colliding state, x is the distance between its centroid now and its centroid at rest
/// (time zero of the bodies as placed, before settling) and x' = u . u' / |u|, u the centroid's displacement;
/// F(x, x') acts along the triangle's contact normal; the total is the sum. A triangle without a contact of
/// its own takes the weighted mean normal of the contacts at its vertices.
class TriangleForces {
 public:
  TriangleForces(const Scene& scene, std::vector<TriangleLaw> laws, double step_s);

  /// Once a step: fills state.forces, one entry a law: forces ON THE TOOLS, newtons.
  void evaluate(const ContactPatch& patch, State& state);

 private:
  std::vector<Face> faces_;  ///< all bodies, vertex indices into State arrays
  std::vector<Vec3> rest_centroids_m_;
  std::vector<Vec3> last_centroids_m_;  ///< of the last step
  std::vector<TriangleLaw> laws_;
  double step_s_;
};

}  // namespace fissure
