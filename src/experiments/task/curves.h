#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/record.h"

namespace fissure {

/// Quantities over a common time.
struct SweepCurves {
  std::vector<std::string> quantities;  ///< see curveQuantities()
  double every_s = 0;                   ///< > 0
  std::optional<double> until_s;        ///< >= every_s; default: the longest of the runs that planning checks
};

/// The curves of these names over runs with this layout: "force" (magnitude), "force_elastic",
/// "force_viscous" of every law; "indentation", the way of the first tool since it first touched tissue;
/// every series with one value a step under its own name. Throws InputError about `where` for a name that is
/// none of them.
std::vector<CurveQuantity> curveQuantities(const std::vector<std::string>& names, const RecordLayout& layout,
                                           const std::string& where);

/// The times of the curves: 0, every_s, 2 every_s ... until_s.
std::vector<double> curveTimes_s(const SweepCurves& curves);

}  // namespace fissure
