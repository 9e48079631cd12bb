#include "report/step_times.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "measure/statistics.h"
#include "report/summary_values.h"
#include "store/read_series.h"

namespace fissure {

PageJson distributionJson(std::vector<double> times_us) {
  std::erase_if(times_us, [](double time) { return !std::isfinite(time); });
  std::sort(times_us.begin(), times_us.end());
  PageJson us = PageJson::array(), percent = PageJson::array();
  constexpr std::size_t slowest = 20, points = 200;
  const std::size_t count = times_us.size();
  const std::size_t stride = std::max<std::size_t>(1, count / points);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % stride != 0 && i + slowest < count) continue;
    us.push_back(shortNumber(times_us[i]));
    percent.push_back(shortNumber(100 * static_cast<double>(i + 1) / static_cast<double>(count)));
  }
  const auto over =
      std::count_if(times_us.begin(), times_us.end(), [](double time) { return time > haptic_budget_us; });
  return {{"steps", count},
          {"p50_us", shortNumber(percentile(times_us, 50))},
          {"p99_us", shortNumber(percentile(times_us, 99))},
          {"max_us", shortNumber(percentile(times_us, 100))},
          {"over_budget", over},
          {"curve_us", us},
          {"curve_percent", percent}};
}

PageJson stepTimesJson(const std::filesystem::path& file, const ResultInfo& info,
                       const std::vector<ReportRun>& runs) {
  PageJson all = PageJson::array();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::string path = "/pipelines/" + runs[r].result->name + "/timing/step_time_us";
    const bool stored = std::any_of(info.datasets.begin(), info.datasets.end(),
                                    [&](const DatasetInfo& dataset) { return dataset.path == path; });
    if (!stored) continue;
    const SummaryValue* steps = findValue(runs[r].result->summary, "steps");
    PageJson json = {{"run", r}, {"steps_of_run", steps ? numberOf(*steps).value_or(0) : 0}};
    json.update(distributionJson(readSeries(file, path).values));
    if (json["steps"] != 0) all.push_back(json);
  }
  return {{"budget_us", haptic_budget_us}, {"runs", all}};
}

}  // namespace fissure
