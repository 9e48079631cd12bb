#pragma once

#include <filesystem>
#include <vector>

#include "scenario/load.h"
#include "store/result_file.h"

namespace fissure {

/// assembleResult() in a process of its own (apart.h). When that is lost, each run is assembled alone in the
/// folder `scratch`: one whose part is to blame loses it and fails ("part file unreadable"), and the others
/// get their result all the same. Throws RunError.
void assembleApart(const std::filesystem::path& output, const LoadedScenario& loaded,
                   const Provenance& provenance, std::vector<PartResult>& parts,
                   const std::filesystem::path& scratch);

/// assembleSalvaged() in a process of its own. Throws RunError, and InputError when the part is damaged.
void salvageApart(const std::filesystem::path& output, const LoadedScenario& loaded,
                  const Provenance& provenance, const PartResult& part);

}  // namespace fissure
