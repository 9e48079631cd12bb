#pragma once

#include <limits>

#include "base/geometry.h"

namespace fissure {

/// Largest speed and acceleration of a point that is seen once a step: its differences over one step and over
/// two. A speed that changes at once, as that of a script with constant speed, gives an acceleration of the
/// change over a step.
class MotionPeaks {
 public:
  explicit MotionPeaks(double step_s) : step_s_(step_s) {}

  void add(const Vec3& position_m);
  /// NaN with fewer than two positions, and after one that is not a number.
  double speed_m_s() const { return speed_m_s_; }
  /// NaN with fewer than three, and after one that is not a number.
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
