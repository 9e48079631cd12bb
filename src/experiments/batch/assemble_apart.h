#pragma once

#include <filesystem>
#include <vector>

#include "scenario/load.h"
#include "store/result_file.h"

namespace fissure {

/// Calls assembleResult() in a child process (doApart), because HDF5 may crash on a damaged part. When that
/// process is lost, each run is first assembled alone in the folder `scratch`: a run whose part is damaged
/// loses it and fails ("part file unreadable"), and the result is assembled from the others. Throws RunError
/// when writing fails.
void assembleApart(const std::filesystem::path& output, const LoadedScenario& loaded,
                   const Provenance& provenance, std::vector<PartResult>& parts,
                   const std::filesystem::path& scratch);

/// Calls assembleSalvaged() in a child process. Throws RunError when writing fails, InputError when the part
/// is damaged.
void salvageApart(const std::filesystem::path& output, const LoadedScenario& loaded,
                  const Provenance& provenance, const PartResult& part);

}  // namespace fissure
