#pragma once

#include <string>

#include "sweep/sweep_plan.h"

namespace fissure {

/// What a sweep will run, as lines for people: its size, then each axis with its range or values, and of
/// which axis no run takes notice.
std::string planText(const SweepPlan& plan);

/// The values of a simulation, as in `overrides`: "bodies.ball.mass_kg=0.1, 8 sets of force laws".
std::string valuesText(const SweepPlan& plan, const SweepTask& task);

}  // namespace fissure
