#pragma once

#include <filesystem>

#include "sweep/sweep_manifest.h"

namespace fissure {

/// More runs than this need a word of consent; more than max_sweep_runs are refused.
inline constexpr double many_sweep_runs = 1e5;
inline constexpr double max_sweep_runs = 2e6;

/// Reads a sweep file and its base scenario and makes the plan for `folder`, where nothing is written.
/// Scenarios are checked as `run` checks them until every value of every axis has been in one, a thousand
/// at most: what is wrong with a combination beyond that shows when its turn comes. Throws InputError, also
/// for more than many_sweep_runs runs unless `allow_many` is true.
SweepManifest planSweep(const std::filesystem::path& file, const std::filesystem::path& folder,
                        bool allow_many);

/// Writes the plan into its folder, in place of an earlier one of the same sweep. Throws InputError when the
/// folder is another sweep's or holds something else, RunError when it cannot be written.
void putManifest(const SweepManifest& manifest, const std::filesystem::path& folder);

/// Throws InputError when the worker programs or the scenario's input files are not those of the plan.
void refuseOtherPlan(const SweepManifest& manifest, const std::filesystem::path& folder);

}  // namespace fissure
