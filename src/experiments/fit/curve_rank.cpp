#include "fit/curve_rank.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace fissure {

Misfit misfitOf(const MeasuredCurve& curve, MatchBy by, std::span<const double> at,
                std::span<const double> force_N, std::optional<double> fixed_offset_N) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double>& measured = by == MatchBy::time ? curve.time_s : curve.depth_m;
  std::vector<double> differences_N;
  double weights = 0, weighted_N = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (at.empty() || !(measured[i] >= at.front()) || measured[i] > at.back()) return {.rms_N = none};
    const auto after =
        static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), measured[i]) - at.begin());
    double simulated_N = force_N[after];
    if (at[after] > measured[i]) {
      const double share = (measured[i] - at[after - 1]) / (at[after] - at[after - 1]);
      simulated_N = (1 - share) * force_N[after - 1] + share * force_N[after];
    }
    differences_N.push_back(curve.force_N[i] - simulated_N);
    weights += curve.weights[i];
    weighted_N += curve.weights[i] * differences_N.back();
  }
  if (differences_N.empty()) return {.rms_N = none};
  Misfit misfit{.F0_N = fixed_offset_N.value_or(weighted_N / weights)};
  double squares_N2 = 0;
  for (std::size_t i = 0; i < differences_N.size(); ++i)
    squares_N2 += curve.weights[i] * std::pow(differences_N[i] - misfit.F0_N, 2);
  misfit.rms_N = std::sqrt(squares_N2 / weights);
  return misfit;
}

void keepDeepening(std::vector<double>& way_m, std::vector<double>& force_N) {
  const auto deeper = std::find_if(way_m.begin(), way_m.end(), [](double way) { return way > 0; });
  const auto start = static_cast<std::size_t>(deeper - way_m.begin());
  std::size_t kept = 0;
  for (std::size_t i = start == 0 ? 0 : start - 1; i < way_m.size(); ++i) {
    if (kept > 0 && !(way_m[i] > way_m[kept - 1])) continue;
    way_m[kept] = way_m[i];
    force_N[kept++] = force_N[i];
  }
  way_m.resize(kept);
  force_N.resize(kept);
}

std::string wayBackNote(const MeasuredCurve& curve) {
  if (curve.time_s.empty() || curve.depth_m.empty()) return "";
  const double margin_m = 0.01 * *std::max_element(curve.depth_m.begin(), curve.depth_m.end());
  double deepest_m = 0;
  std::size_t back = 0;
  for (const double depth_m : curve.depth_m) {
    deepest_m = std::max(deepest_m, depth_m);
    if (depth_m < deepest_m - margin_m) ++back;
  }
  if (back == 0) return "";
  return fmt::format(
      "{} of {} points are shallower than one before them, as on a way back, and meet the simulated way in: "
      "--match time tells them apart",
      back, curve.depth_m.size());
}

void rank(std::vector<Misfit>& misfits) {
  std::sort(misfits.begin(), misfits.end(), [](const Misfit& a, const Misfit& b) {
    return std::make_tuple(std::isnan(a.rms_N), std::isnan(a.rms_N) ? 0 : a.rms_N, a.run, a.law) <
           std::make_tuple(std::isnan(b.rms_N), std::isnan(b.rms_N) ? 0 : b.rms_N, b.run, b.law);
  });
}

}  // namespace fissure
