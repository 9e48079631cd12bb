#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/record.h"
#include "scenario/key.h"

namespace fissure {

/// Quantities that a sweep keeps as curves, at common times.
struct SweepCurves {
  std::vector<std::string> quantities;
  double every_s = 0;
  std::optional<double> until_s;
};

template <class Io>
void describe(Io& io, SweepCurves& curves) {
  io.field(
      "quantities", curves.quantities,
      Key("Names of series with one value per step, or `force` (its magnitude), `force_elastic` and "
          "`force_viscous` of each law, or `indentation`, the displacement of the first tool since it first "
          "touched tissue.")
          .required());
  io.field("every_s", curves.every_s, Key("Time between two values.").above(0).required());
  io.field(
      "until_s", curves.until_s,
      Key("Time of the last value, at least `every_s`.").above(0).otherwise("the end of the longest run"));
}

/// The curves with these names for runs with this layout: "force" (magnitude), "force_elastic" and
/// "force_viscous" of every law; "indentation", the displacement of the first tool since it first touched
/// tissue; and every series with one value per step under its own name. Throws InputError about `where` for
/// any other name.
std::vector<CurveQuantity> curveQuantities(const std::vector<std::string>& names, const RecordLayout& layout,
                                           const std::string& where);

/// The times of the curves: 0, every_s, 2 every_s ... until_s, seconds.
std::vector<double> curveTimes_s(const SweepCurves& curves);

}  // namespace fissure
