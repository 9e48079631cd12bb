#include "sweep/sweep_misfit.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

MeasuredCurve onlyCurve(const SweepFit& fit, const std::filesystem::path& file) {
  std::vector<MeasuredCurve> curves =
      readCurves(file, fit.columns ? parseCurveColumns(*fit.columns) : std::vector<CurveColumn>());
  if (curves.size() > 1)
    throw InputError(
        inFile(file),
        fmt::format("has {} curves ({}, {}{}), expected one to hold the runs against", curves.size(),
                    curves[0].name, curves[1].name, curves.size() > 2 ? ", ..." : ""));
  return std::move(curves.front());
}

}  // namespace

SweepMisfit::SweepMisfit(const SweepFit& fit, const std::vector<std::string>& laws,
                         const std::filesystem::path& file)
    : match_(fit.match),
      fixed_offset_N_(fit.free_offset ? std::nullopt : std::optional<double>(0)),
      curve_(onlyCurve(fit, file)) {
  if (fit.law) law_ = static_cast<std::size_t>(std::find(laws.begin(), laws.end(), *fit.law) - laws.begin());
  const bool by_time = match_ == MatchBy::time;
  if ((by_time ? curve_.time_s : curve_.depth_m).empty())
    throw InputError(inFile(file), fmt::format("has no column of {}, expected one to match runs by",
                                               by_time ? "times" : "depths"));
}

Misfit SweepMisfit::of(const std::vector<double>& time_s, std::span<const double> force_N,
                       std::span<const double> way_m) const {
  const auto start = force_N.begin() + static_cast<std::ptrdiff_t>(law_ * time_s.size());
  std::vector<double> of_law_N(start, start + static_cast<std::ptrdiff_t>(time_s.size()));
  if (match_ == MatchBy::time) return misfitOf(curve_, match_, time_s, of_law_N, fixed_offset_N_);
  std::vector<double> way(way_m.begin(), way_m.end());
  keepDeepening(way, of_law_N);
  return misfitOf(curve_, match_, way, of_law_N, fixed_offset_N_);
}

std::vector<double> SweepMisfit::at(const std::vector<double>& time_s) const {
  std::vector<double> forces_N;
  if (match_ != MatchBy::time) return forces_N;
  const std::vector<double>& measured_s = curve_.time_s;
  for (const double time : time_s) {
    const auto after = std::lower_bound(measured_s.begin(), measured_s.end(), time);
    const auto i = static_cast<std::size_t>(after - measured_s.begin());
    if (after == measured_s.end() || (i == 0 && *after > time)) {
      forces_N.push_back(kMissing);
    } else if (*after == time) {
      forces_N.push_back(curve_.force_N[i]);
    } else {
      const double share = (time - measured_s[i - 1]) / (measured_s[i] - measured_s[i - 1]);
      forces_N.push_back((1 - share) * curve_.force_N[i - 1] + share * curve_.force_N[i]);
    }
  }
  return forces_N;
}

}  // namespace fissure
