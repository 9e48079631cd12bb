#pragma once

#include "scenario/motions.h"

namespace fissure {

/// Share of the path that is covered after the share `u` of the time (both 0..1; exactly 0 and 1 at the
/// ends). `ramp_fraction`, in (0, 0.5]: share of the time for each ramp of the trapezoidal profile; the other
/// profiles ignore it.
double wayCovered(Timing timing, double ramp_fraction, double u);

}  // namespace fissure
