#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "sweep/sweep_state.h"

namespace fissure {

/// What makes a result file one that is not lost. Neither opens a file whose size and time are as recorded.
enum class ResultCheck {
  size,  ///< as recorded, or it can be read: in a copied folder, where all times are new, no file is opened
  contents  ///< it can be read
};

/// Makes those of `tasks` missing again whose result file in the sweep's folder somebody removed or damaged.
/// Nothing where the sweep keeps no results.
void forgetLostResults(SweepState& state, const std::filesystem::path& folder,
                       const std::vector<std::size_t>& tasks, ResultCheck check);

}  // namespace fissure
