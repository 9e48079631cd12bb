#pragma once

#include <string_view>
#include <vector>

#include "scenario/forces.h"

namespace fissure {

/// F = k d^n + F0 fitted to the median of measured probing curves: the force of a whole spherical probe
/// against its depth d. The simulation's law sums over triangles against the way of their centroids: with
/// these numbers its exponent is the tissue's, its size is not (METHOD: force).
struct Tissue {
  std::string_view name;
  double k = 0;  ///< N/m^n
  double n = 0;
  std::string_view description;  ///< the numbers, how deep they hold, and where they are from
};

/// All of them: catalog().tissues lists them.
const std::vector<Tissue>& tissues();

/// The measurements hardly say lambda: lambda/k lies between -0.3 and 1.3 s/m up to 0.04 m/s. An assumption.
constexpr double assumed_lambda_over_k_s_m = 0.5;

/// Sets k, n and lambda of a Hunt-Crossley law by its `tissue`; without one, or with an unknown one, nothing.
void applyTissue(ForceSettings& law);

}  // namespace fissure
