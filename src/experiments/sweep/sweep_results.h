#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "sweep/sweep_state.h"

namespace fissure {

/// The criterion by which a result file counts as intact. Files whose size and time are as recorded are not
/// opened with either.
enum class ResultCheck {
  /// Its size is as recorded, or it can be read; in a copied folder, where all times are new, no file is
  /// opened.
  size,
  contents  ///< it can be read
};

/// Marks those of `tasks` as missing whose result file in the sweep's folder was removed or damaged. Does
/// nothing where the sweep keeps no results.
void forgetLostResults(SweepState& state, const std::filesystem::path& folder,
                       const std::vector<std::size_t>& tasks, ResultCheck check);

}  // namespace fissure
