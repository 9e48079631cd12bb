#pragma once

#include <limits>

#include "base/geometry.h"

namespace fissure {

/// Largest speed and acceleration of a point whose position is sampled once per step, by finite differences
/// over one and over two steps. A jump of the velocity, as at the ends of a script with constant speed,
/// counts as an acceleration of that change over one step.
class MotionPeaks {
 public:
  explicit MotionPeaks(double step_s) : step_s_(step_s) {}

  /// Takes the position at the end of the next step.
  void add(const Vec3& position_m);
  /// Largest speed so far; NaN with fewer than two positions, and after a position that is not a number.
  double speed_m_s() const { return speed_m_s_; }
  /// Largest acceleration so far; NaN with fewer than three positions, and after one that is not a number.
  double acceleration_m_s2() const { return acceleration_m_s2_; }

 private:
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

  double step_s_;
  int seen_ = 0;  ///< positions, counted up to three
  Vec3 last_m_ = Vec3::Zero();
  Vec3 last_velocity_m_s_ = Vec3::Zero();
  double speed_m_s_ = missing;
  double acceleration_m_s2_ = missing;
};

}  // namespace fissure
