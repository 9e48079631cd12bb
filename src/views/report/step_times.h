#pragma once

#include <filesystem>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// What a haptic loop leaves a step, microseconds: 1 kHz.
inline constexpr double haptic_budget_us = 1000;

/// How the wall times of the steps are distributed: {budget_us, runs: [{run, steps, p50_us, p99_us, max_us,
/// over_budget, curve_us, curve_percent}]}, runs without times left out. The curve is the share of the steps
/// that took at most so long, with the slowest steps all in it. Throws InputError when they cannot be read.
PageJson stepTimesJson(const std::filesystem::path& file, const ResultInfo& info,
                       const std::vector<ReportRun>& runs);

/// The same for the times of one run; those that are not finite count as not measured.
PageJson distributionJson(std::vector<double> times_us);

}  // namespace fissure
