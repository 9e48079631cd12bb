#pragma once

#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "contact/rigid_fit.h"
#include "law/deformation.h"

namespace fissure {

/// The displacement u of every triangle's centroid from rest, for one kind of deformation, and its rate u'
/// (contact/METHOD.md 12). Corotated vectors are in the frame of the body at rest, so that a rotation of the
/// whole body contributes to neither; others are in the scene frame.
class TriangleDeformation {
 public:
  /// `sources`: the sources of rates that will be asked for; nothing is kept for others.
  TriangleDeformation(const Scene& scene, DeformationKind kind, const std::vector<RateSource>& sources,
                      double step_s);

  /// To be called once per step, before the functions below.
  void update(const State& state);

  /// u of a triangle, metres, and u' of a triangle, m/s. Triangles are counted over all bodies.
  Vec3 displacement(std::size_t triangle) const { return now_m_[triangle] - rest_m_[triangle]; }
  Vec3 rate(std::size_t triangle, RateSource source, const State& state) const;

  DeformationKind kind() const { return kind_; }
  /// Number of rigid fits so far: one per body and step if corotated.
  long long rigidFits() const { return rigid_fits_; }

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
  std::vector<RigidFit> fits_;        ///< one per body; empty for `paper`
  std::vector<Vec3> rest_m_, now_m_;  ///< centroids
  std::vector<Vec3> last_m_;          ///< centroids of the last step; empty without differences
  long long rigid_fits_ = 0;
};

}  // namespace fissure
