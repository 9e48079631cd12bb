#pragma once

#include <filesystem>

#include "sweep/sweep_manifest.h"

namespace fissure {

/// Sweeps with more runs than this need the user's consent; those with more than max_sweep_runs are refused.
inline constexpr double many_sweep_runs = 1e5;
inline constexpr double max_sweep_runs = 2e6;

/// Reads a sweep file and its base scenario and makes the plan for `folder`, without writing there. Scenarios
/// are checked as by `fissure run` until every value of every axis has occurred in one, at most a thousand of
/// them; errors in further combinations show when they are run. Throws InputError, also for more than
/// many_sweep_runs runs unless `allow_many` is true.
SweepManifest planSweep(const std::filesystem::path& file, const std::filesystem::path& folder,
                        bool allow_many);

/// Writes the plan into its folder, replacing an earlier one of the same sweep. Throws InputError when the
/// folder belongs to another sweep or has other contents, RunError when writing fails.
void putManifest(const SweepManifest& manifest, const std::filesystem::path& folder);

/// Throws InputError where putManifest() would, because of what the folder holds.
void refuseOtherFolder(const SweepManifest& manifest, const std::filesystem::path& folder);

/// Throws InputError when the worker programs or the scenario's input files have changed since the plan was
/// made.
void refuseOtherPlan(const SweepManifest& manifest, const std::filesystem::path& folder);

}  // namespace fissure
