#pragma once

#include <string>

#include "sweep/sweep_plan.h"

namespace fissure {

/// The reason why an axis has no effect on any run of a sweep, as far as its path shows: "no run has nodes".
/// Empty where it may have an effect.
std::string idleReason(const SweepPlan& plan, std::size_t axis);

}  // namespace fissure
