#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "study/match_by.h"
#include "study/measured_curve.h"

namespace fissure {

/// How far a simulated curve is from a measured one.
struct Misfit {
  std::size_t run = 0;
  std::size_t law = 0;
  double rms_N = 0;  ///< root of the (weighted) mean square of the differences; NaN: cannot be compared
  double F0_N = 0;   ///< what was added to the simulated force
};

/// `force_N` over ascending `at`, times or depths as `by` says, against the curve's points in between
/// (linearly). With `free_offset` F0 is the one of the least misfit, else 0. NaN where the simulated curve
/// has a gap or an end before the last point, or the curve has no such points.
Misfit misfitOf(const MeasuredCurve& curve, MatchBy by, std::span<const double> at,
                std::span<const double> force_N, bool free_offset);

/// The same points of a curve over the way of a tool instead of time: those from first contact to the
/// deepest that go deeper than all before. All three of one length; `way_m` is 0 before contact.
void keepDeepening(std::vector<double>& way_m, std::vector<double>& force_N);

/// Least misfit first, NaN last, equal ones by run and law.
void rank(std::vector<Misfit>& misfits);

}  // namespace fissure
