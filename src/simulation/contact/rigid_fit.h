#pragma once

#include <vector>

#include "base/scene.h"

namespace fissure {

/// The best-fit rigid motion of a soft body since rest: the rotation R and translation that minimise sum(a |x
/// - x_mean - R (X - X_mean)|^2) over its vertices (Kabsch 1976; contact/METHOD.md 12, `corotated`), with
/// positions X at rest and x now. The weight a, also of the means, is a third of the rest area of the
/// triangles around the vertex, so that the fit does not depend on the triangulation or the distribution of
/// mass. R is never a reflection.
class RigidFit {
 public:
  explicit RigidFit(const SceneBody& body);

  /// Fits the motion to `positions_m` ([vertex] of all bodies, scene frame). Non-finite positions make all
  /// results NaN.
  void fit(const std::vector<Vec3>& positions_m);
  /// Computes the rates of the fitted motion for `velocities_m_s` ([vertex] of all bodies) at the positions
  /// of the last fit().
  void fitRates(const std::vector<Vec3>& velocities_m_s);

  /// Moves a point (scene frame) back by the fitted motion, so that it can be compared with its rest
  /// position.
  Vec3 toRest(const Vec3& point_m) const;
  /// Rate of change of toRest() for a point that moves with `velocity_m_s`.
  Vec3 velocityInRest(const Vec3& point_m, const Vec3& velocity_m_s) const;

 private:
  Vec3 mean(const std::vector<Vec3>& of_vertices) const;

  int first_vertex_;
  std::vector<double> weights_;    ///< sum 1
  std::vector<Vec3> rest_arms_m_;  ///< X - X_mean
  Vec3 rest_mean_m_;
  Vec3 mean_m_;
  Mat3 rotation_;  ///< R, from rest to now
  Mat3 stretch_;   ///< sum(a (x - x_mean) (X - X_mean)^T) = R stretch
  Vec3 mean_velocity_m_s_ = Vec3::Zero();
  Vec3 turning_rad_s_ = Vec3::Zero();  ///< angular velocity of R, rest frame
};

}  // namespace fissure
