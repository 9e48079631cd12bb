#pragma once

#include <cstddef>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// The stored frames of all runs as WebP data URIs of together at most `most_bytes` (or, where that is
/// impossible, two small ones of each run): {stored, shown, smaller, runs: [{run, times_s, images}]}; null
/// where no run has frames. What does not fit becomes first coarser, then smaller, then fewer: evenly spread,
/// the first and the last kept. Throws InputError when they cannot be read.
PageJson framesJson(const std::vector<ReportRun>& runs, std::size_t most_bytes);

/// `most` of `count` indices, ascending and evenly spread, the first and the last among them; all where
/// there are no more. `most` > 1.
std::vector<std::size_t> evenlySpread(std::size_t count, std::size_t most);

}  // namespace fissure
