#pragma once

#include <cstddef>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The stored frames of all runs as WebP data URIs: {stored, shown, smaller, runs: [{run, times_s, images}]};
/// null where no run has frames. Together they have at most `most_bytes`, or, where that is impossible, there
/// are two small ones per run. To fit, frames are first compressed more, then made smaller, then thinned out
/// evenly, with the first and the last kept. Throws InputError when they cannot be read.
PageJson framesJson(const std::vector<ReportRun>& runs, std::size_t most_bytes);

/// At most `most` of the indices 0 .. count - 1, ascending and evenly spread, including the first and the
/// last. `most` > 1.
std::vector<std::size_t> evenlySpread(std::size_t count, std::size_t most);

}  // namespace fissure
