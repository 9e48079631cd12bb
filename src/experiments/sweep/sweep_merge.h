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

/// The numbers of a sweep's runs by their ends.
std::map<RunEnd, std::size_t> countRuns(const SweepPlan& plan, const SweepState& state);

/// Writes the sweep's table with all rows, and its CSV. Rows without numbers have the reason in status and
/// status_detail. The same records give the same data, whatever journals they are in. Each file is replaced
/// completely or not at all. Throws RunError when writing fails.
void writeSweepTables(const SweepPlan& plan, const SweepState& state, const std::filesystem::path& folder,
                      const Provenance& provenance);

/// Whether the sweep has a measured curve, but its table in `folder` no run that could be compared with it.
bool comparesNothing(const SweepPlan& plan, const std::filesystem::path& folder);

}  // namespace fissure
