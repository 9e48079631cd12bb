#include "base/motion_peaks.h"

#include <cmath>

namespace fissure {

namespace {

/// NaN stays.
void raise(double& largest, bool first, double value) {
  if (first || std::isnan(value) || value > largest) largest = value;
}

}  // namespace

void MotionPeaks::add(const Vec3& position_m) {
  const Vec3 velocity_m_s = (position_m - last_m_) / step_s_;
  if (seen_ > 0) raise(speed_m_s_, seen_ == 1, velocity_m_s.norm());
  if (seen_ > 1) {
    const double acceleration_m_s2 = (velocity_m_s - last_velocity_m_s_).norm() / step_s_;
    raise(acceleration_m_s2_, seen_ == 2, acceleration_m_s2);
  }
  last_m_ = position_m;
  last_velocity_m_s_ = velocity_m_s;
  if (seen_ < 3) ++seen_;
}

}  // namespace fissure
