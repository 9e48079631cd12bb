#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/measured_curve.h"

namespace fissure {

/// What `fissure fit --modulus` was asked for.
struct ModulusRequest {
  std::vector<std::string> results;  ///< FILE or FILE:RUN each
  std::string free;                  ///< "E,F0"; empty: these
  std::vector<std::string> fixed;    ///< "d0=0.0002"
  std::optional<double> most_depth_m;
  bool json = false;
};

/// Fits the modulus of every result to every curve, prints what came of it, and returns the exit code. Throws
/// InputError where there is nothing to print.
int fitModuli(const ModulusRequest& request, const std::vector<MeasuredCurve>& curves);

}  // namespace fissure
