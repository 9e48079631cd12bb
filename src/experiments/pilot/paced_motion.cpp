#include "pilot/paced_motion.h"

#include <algorithm>
#include <cmath>

namespace fissure {

double PacedMotion::timeOfRun_s(double time_s) const {
  const double step = std::clamp(time_s / step_s_, 0.0, static_cast<double>(pace_.steps()));
  const double whole = std::min(std::floor(step + 1e-6), static_cast<double>(pace_.steps() - 1));
  const auto before = static_cast<std::size_t>(whole);
  const auto from = static_cast<double>(pace_.run_steps[before]);
  const auto to = static_cast<double>(pace_.run_steps[before + 1]);
  return (from + (step - whole) * (to - from)) * step_s_;
}

}  // namespace fissure
