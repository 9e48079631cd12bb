#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/match_by.h"
#include "fit/measured_curve.h"

namespace fissure {

/// How far a simulated curve is from a measured one.
struct Misfit {
  std::size_t run = 0;
  std::size_t law = 0;
  double rms_N = 0;  ///< root of the (weighted) mean square of the differences; NaN: cannot be compared
  double F0_N = 0;   ///< what was added to the simulated force
};

/// `force_N` over ascending `at`, times or depths as `by` says, against the curve's points in between
/// (linearly). F0 is `fixed_offset_N` or, without, the one of the least misfit. NaN where the simulated curve
/// has a gap or an end before the last point, or the curve has no such points.
Misfit misfitOf(const MeasuredCurve& curve, MatchBy by, std::span<const double> at,
                std::span<const double> force_N, std::optional<double> fixed_offset_N);

/// The same points of a curve over the way of a tool instead of time: those from first contact to the
/// deepest that go deeper than all before. All three of one length; `way_m` is 0 before contact.
void keepDeepening(std::vector<double>& way_m, std::vector<double>& force_N);

/// What must be said where depths are matched: how many points are shallower than one before them by more
/// than a hundredth of the deepest, as on a way back, although all meet the simulated way in. Empty: none, or
/// the curve has no times.
std::string wayBackNote(const MeasuredCurve& curve);

/// Least misfit first, NaN last, equal ones by run and law.
void rank(std::vector<Misfit>& misfits);

}  // namespace fissure
