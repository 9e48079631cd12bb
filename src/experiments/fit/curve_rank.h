#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/match_by.h"
#include "fit/measured_curve.h"

namespace fissure {

/// The deviation of a simulated curve from a measured one.
struct Misfit {
  std::size_t run = 0;
  std::size_t law = 0;
  double rms_N = 0;  ///< root of the (weighted) mean square of the differences; NaN: cannot be compared
  double F0_N = 0;   ///< offset that was added to the simulated force
};

/// Compares the simulated `force_N` over ascending `at` (times or depths, according to `by`), linearly
/// interpolated, with the points of the measured curve. F0 is `fixed_offset_N` or, without it, that of the
/// least misfit. rms_N is NaN where the simulated curve has a gap or ends before the last point, or the
/// measured curve has no such points.
Misfit misfitOf(const MeasuredCurve& curve, MatchBy by, std::span<const double> at,
                std::span<const double> force_N, std::optional<double> fixed_offset_N);

/// Reduces a curve to the points from first contact to the deepest that are deeper than all points before, so
/// that it is a function of depth. `way_m`, the displacement of the tool, is 0 before contact; both arrays
/// have the same length.
void keepDeepening(std::vector<double>& way_m, std::vector<double>& force_N);

/// A note for matching by depth: the number of points that are shallower than an earlier one by more than a
/// hundredth of the deepest, as during retraction, although all points are compared with the simulated
/// indentation. Empty where there are none, or the curve has no times.
std::string wayBackNote(const MeasuredCurve& curve);

/// Sorts by misfit, the least first and NaN last; equal ones by run and law.
void rank(std::vector<Misfit>& misfits);

}  // namespace fissure
