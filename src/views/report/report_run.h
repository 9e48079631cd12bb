#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "store/result_file.h"
#include "store/run_reader.h"

namespace fissure {

/// What the page's script reads: keys keep their order, so that equal results give equal pages.
using PageJson = nlohmann::ordered_json;

/// One run of a result, opened. `result` belongs to the ResultInfo that it was opened from.
struct ReportRun {
  const PipelineResult* result = nullptr;
  RunReader reader;
  std::vector<double> times_s;  ///< one a row; empty where the run left no series
};

/// Throws InputError when a run cannot be read.
std::vector<ReportRun> openRuns(const std::filesystem::path& file, const ResultInfo& info);

/// Six digits, which is more than a plot shows and half the bytes; null for what is not finite.
PageJson shortNumber(double value);

}  // namespace fissure
