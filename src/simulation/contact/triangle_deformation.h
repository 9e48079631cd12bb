#pragma once

#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/rigid_fit.h"
#include "law/deformation.h"

namespace fissure {

/// u, the displacement of every triangle's centroid from rest, by one kind of deformation, and its rate u'.
/// Corotated vectors are in the frame of the body at rest, so that turning as a whole is no rate either.
class TriangleDeformation {
 public:
  /// `sources`: those that will be asked for; nothing is kept for the others.
  TriangleDeformation(const Scene& scene, DeformationKind kind, const std::vector<RateSource>& sources,
                      double step_s);

  /// Once a step, before the rest.
  void update(const State& state);

  Vec3 displacement(std::size_t triangle) const { return now_m_[triangle] - rest_m_[triangle]; }
  Vec3 rate(std::size_t triangle, RateSource source, const State& state) const;

  DeformationKind kind() const { return kind_; }
  long long rigidFits() const { return rigid_fits_; }  ///< made so far: one a body and step if corotated

 private:
  struct Triangle {
    Face face{};  ///< vertex indices into State arrays
    int body = 0;
  };
  Vec3 centroid(std::size_t triangle, const std::vector<Vec3>& of_vertices) const;

  DeformationKind kind_;
  bool differences_ = false, velocities_ = false;
  double step_s_;
  std::vector<Triangle> triangles_;
  std::vector<RigidFit> fits_;        ///< one a body; none for paper
  std::vector<Vec3> rest_m_, now_m_;  ///< centroids
  std::vector<Vec3> last_m_;          ///< of the last step; empty without differences
  long long rigid_fits_ = 0;
};

}  // namespace fissure
