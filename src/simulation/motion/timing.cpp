#include "motion/timing.h"

namespace fissure {
namespace {

/// Velocity rises linearly over `ramp`, stays at its peak and falls over `ramp`. The peak 1 / (1 - ramp)
/// makes the area under it 1.
double trapezoidal(double ramp, double u) {
  const double peak = 1 / (1 - ramp);
  if (u < ramp) return peak * u * u / (2 * ramp);
  if (u > 1 - ramp) return 1 - peak * (1 - u) * (1 - u) / (2 * ramp);
  return peak * (u - ramp / 2);
}

/// Flash and Hogan, J. Neuroscience 5 (1985), 1688: the point-to-point movement of least squared jerk.
double minimumJerk(double u) {
  return u * u * u * (10 + u * (6 * u - 15));
}

}  // namespace

double wayCovered(Timing timing, double ramp_fraction, double u) {
  if (u <= 0) return 0;
  if (u >= 1) return 1;
  switch (timing) {
    case Timing::trapezoidal:
      return trapezoidal(ramp_fraction, u);
    case Timing::minimum_jerk:
      return minimumJerk(u);
    case Timing::constant:
      break;
  }
  return u;
}

}  // namespace fissure
