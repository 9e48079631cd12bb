#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "store/result_file.h"
#include "store/run_reader.h"

namespace fissure {

/// JSON for the page's script. Keys keep their order, so that equal results give equal pages.
using PageJson = nlohmann::ordered_json;

/// An opened run of a result. `result` points into the ResultInfo from which it was opened.
struct ReportRun {
  const PipelineResult* result = nullptr;
  RunReader reader;
  std::vector<double> times_s;  ///< [row] empty where the run left no series
};

/// Opens all runs of a result. Throws InputError when a run cannot be read.
std::vector<ReportRun> openRuns(const std::filesystem::path& file, const ResultInfo& info);

/// The number rounded to six digits, which is more than a plot shows and saves half of the bytes; null where
/// it is not finite.
PageJson shortNumber(double value);

}  // namespace fissure
