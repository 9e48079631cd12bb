#include "report/report_run.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace fissure {

std::vector<ReportRun> openRuns(const std::filesystem::path& file, const ResultInfo& info) {
  std::vector<ReportRun> runs;
  for (const PipelineResult& result : info.pipelines) {
    ReportRun run{&result, RunReader(file, result.name), {}};
    if (const StoredQuantity* time = run.reader.find("time")) run.times_s = run.reader.all(*time);
    runs.push_back(std::move(run));
  }
  return runs;
}

PageJson shortNumber(double value) {
  if (!std::isfinite(value)) return nullptr;
  const double number = std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
  if (number == std::trunc(number) && std::abs(number) < 1e15) return static_cast<long long>(number);
  return number;
}

}  // namespace fissure
