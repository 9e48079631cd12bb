#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fissure {

/// Tolerance for rounding where a time is a whole number of steps or intervals, as a share of one of these.
inline constexpr double step_slack = 1e-9;

/// Least number of steps of length step_s that cover duration_s, within step_slack; may exceed the range of
/// an integer.
inline double stepsToCover(double duration_s, double step_s) {
  return std::ceil(duration_s / step_s - step_slack);
}

/// Number of whole intervals of length every_s that have passed at time_s, within step_slack.
inline double intervalsIn(double time_s, double every_s) {
  return std::floor(time_s / every_s + step_slack);
}

/// Whether a multiple of `every_s` is reached in the step that ends at time `step` x `step_s`. True for step
/// 0, and in every step for an interval shorter than a step.
inline bool isDue(std::int64_t step, double step_s, double every_s) {
  if (step == 0) return true;
  const auto reached = [&](std::int64_t s) { return intervalsIn(static_cast<double>(s) * step_s, every_s); };
  return reached(step) > reached(step - 1);
}

/// How many of the steps 0 to `last_step` are multiples of `every` or the last.
inline std::int64_t everyNth(std::int64_t last_step, std::int64_t every) {
  return 1 + (last_step + every - 1) / every;
}

/// For how many of the steps 0 to `steps` isDue() is true.
inline std::int64_t timesDue(std::int64_t steps, double step_s, double every_s) {
  const double end_s = static_cast<double>(steps) * step_s;
  return 1 + std::llround(intervalsIn(end_s, std::max(every_s, step_s)));
}

}  // namespace fissure
