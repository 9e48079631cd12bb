#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "store/result_file.h"
#include "sweep/sweep_state.h"

namespace fissure {

/// `<folder>/sweep.h5`, `<folder>/sweep.csv`.
std::filesystem::path tableFile(const std::filesystem::path& folder);
std::filesystem::path csvFile(const std::filesystem::path& folder);

/// How many runs of a sweep ended in which way.
std::map<RunEnd, std::size_t> countRuns(const SweepPlan& plan, const SweepState& state);

/// Writes the sweep's table, all rows, and its CSV; rows without numbers say why in status and status_detail.
/// The same records give the same data whatever journals they are in. Each file takes its place whole or not
/// at all. Throws RunError.
void writeSweepTables(const SweepPlan& plan, const SweepState& state, const std::filesystem::path& folder,
                      const Provenance& provenance);

/// Whether the sweep has a measured curve, and its table in `folder` no run that could be held against that.
bool comparesNothing(const SweepPlan& plan, const std::filesystem::path& folder);

}  // namespace fissure
