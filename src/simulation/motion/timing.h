#pragma once

#include "scenario/motions.h"

namespace fissure {

/// Share of the way covered after the share `u` of the time (both 0..1; exactly 0 and 1 at the ends).
/// `ramp_fraction`: of the trapezoidal profile, (0, 0.5]; the others do not read it.
double wayCovered(Timing timing, double ramp_fraction, double u);

}  // namespace fissure
