#pragma once

#include <filesystem>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The time for a step in a haptic loop of 1 kHz, microseconds.
inline constexpr double haptic_budget_us = 1000;

/// The distribution of the wall times of steps: {budget_us, runs: [{run, steps, p50_us, p99_us, max_us,
/// over_budget, curve_us, curve_percent}]}, without runs that have no times. The curve is the cumulative
/// distribution, with all of the slowest steps. Throws InputError when the times cannot be read.
PageJson stepTimesJson(const std::filesystem::path& file, const ResultInfo& info,
                       const std::vector<ReportRun>& runs);

/// The same for the times of one run; times that are not finite are ignored.
PageJson distributionJson(std::vector<double> times_us);

}  // namespace fissure
