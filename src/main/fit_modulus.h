#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibrate/press_runs.h"
#include "fit/measured_curve.h"

namespace fissure {

/// The arguments of `fissure fit --modulus`.
struct ModulusRequest {
  /// Each is FILE or FILE:RUN of a result, or a scenario or sweep (.yaml, .yml), which is simulated first.
  std::vector<std::string> results;
  PressOutput output;  ///< where simulated results are kept
  /// Names of free parameters; empty: "E,F0".
  std::string free;
  /// Fixed parameters, as "d0=0.0002".
  std::vector<std::string> fixed;
  std::optional<double> most_depth_m;
  bool json = false;
};

/// Fits a modulus for every pair of result and curve, prints the fits and returns the exit code. Throws
/// InputError where there is nothing to print.
int fitModuli(const ModulusRequest& request, const std::vector<MeasuredCurve>& curves);

}  // namespace fissure
