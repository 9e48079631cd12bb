#pragma once

#include <string_view>
#include <vector>

#include "scenario/forces.h"

namespace fissure {

/// A measured tissue: F = k d^n + F0, fitted to the median of measured probing curves, with the force F of a
/// whole spherical probe and its depth d. The simulation sums a law over triangles and the displacements of
/// their centroids instead: with these coefficients its exponent is that of the tissue, its magnitude is not
/// (contact/METHOD.md 12).
struct Tissue {
  std::string_view name;
  double k = 0;  ///< N/m^n
  double n = 0;
  /// One line for people: the numbers, the depth up to which they hold, and their source.
  std::string_view description;
};

/// All tissues, in the order of catalog().tissues.
const std::vector<Tissue>& tissues();

/// Whether a law has the k of its `tissue`, so that the size of its force is that of a whole probe for each
/// triangle. A k of the scenario's own is the scenario's own business.
bool isOfWholeProbe(const ForceSettings& law);

/// Assumed lambda / k of tissues, s/m. The measurements hardly determine it: they allow -0.3 to 1.3 s/m up to
/// 0.04 m/s.
constexpr double assumed_lambda_over_k_s_m = 0.5;

}  // namespace fissure
