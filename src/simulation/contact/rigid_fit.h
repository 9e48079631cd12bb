#pragma once

#include <vector>

#include "base/scene.h"

namespace fissure {

/// The rigid motion that a soft body as a whole has made since rest: the rotation R and shift that minimise
/// sum(a |x - x_mean - R (X - X_mean)|^2) over its vertices (Kabsch 1976; METHOD: force, `corotated`). X: at
/// rest, x: now, means weighted alike. a: a third of the rest area of the triangles around the vertex, so
/// that the motion does not hang on how the surface is triangulated or its mass spread. Never a reflection.
class RigidFit {
 public:
  explicit RigidFit(const SceneBody& body);

  /// Fits R to `positions_m` (of all bodies). A position that is not finite makes everything NaN.
  void fit(const std::vector<Vec3>& positions_m);
  /// The rates of the fitted motion for `velocities_m_s` at the positions of the last fit().
  void fitRates(const std::vector<Vec3>& velocities_m_s);

  /// Moves a point of the tissue back by the fitted motion, to where rest can be compared with it.
  Vec3 toRest(const Vec3& point_m) const;
  /// Velocity of toRest() of a point that moves with `velocity_m_s`.
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
