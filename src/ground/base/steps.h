#pragma once

#include <cmath>
#include <cstdint>

namespace fissure {

/// Times are whole steps but for rounding: by so much of a step (or of an interval) a time may be too long or
/// too short.
inline constexpr double step_slack = 1e-9;

/// Whole steps of step_s that cover duration_s; what rounding adds to a whole number of steps does not count.
/// May exceed what an integer holds.
inline double stepsToCover(double duration_s, double step_s) {
  return std::ceil(duration_s / step_s - step_slack);
}

/// How many whole intervals have passed at time_s.
inline double intervalsIn(double time_s, double every_s) {
  return std::floor(time_s / every_s + step_slack);
}

/// Is a multiple of `every_s` reached in the step that ends at `step` x `step_s`? Step 0 always is. An
/// interval shorter than a step is due in every step.
inline bool isDue(std::int64_t step, double step_s, double every_s) {
  if (step == 0) return true;
  const auto reached = [&](std::int64_t s) { return intervalsIn(static_cast<double>(s) * step_s, every_s); };
  return reached(step) > reached(step - 1);
}

}  // namespace fissure
