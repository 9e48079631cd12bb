#include "report/sweep_page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "report/packed.h"
#include "report/sweep_curves.h"
#include "report/sweep_failures.h"
#include "table/sweep_table.h"
#include "text/summary_unit.h"

namespace fissure {

namespace {

constexpr std::size_t most_runs = 10000;
constexpr std::size_t most_numbers = 640000;  // four bytes each, four characters for every three
constexpr std::size_t most_levels = 400;      // values of an axis that is drawn as steps
constexpr std::size_t best_fits = 20;
constexpr const char* misfit = "misfit_N";

/// Which of them are shown: all, or a scattered sample.
std::vector<std::size_t> shownRuns(std::size_t runs, std::size_t most) {
  std::vector<std::size_t> shown(runs);
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  if (runs <= most) return shown;
  std::stable_sort(shown.begin(), shown.end(),
                   [](std::size_t a, std::size_t b) { return scattered(a) < scattered(b); });
  shown.resize(most);
  std::sort(shown.begin(), shown.end());
  return shown;
}

template <typename Value>
std::vector<Value> picked(const std::vector<Value>& all, const std::vector<std::size_t>& runs) {
  std::vector<Value> some;
  some.reserve(runs.size());
  for (const std::size_t run : runs) some.push_back(all[run]);
  return some;
}

/// Splits the combinations of values so far by the values of one more axis; returns how many of these differ.
template <typename Value>
std::size_t splitBy(const std::vector<Value>& values, std::vector<std::size_t>& combinations) {
  std::map<std::pair<std::size_t, Value>, std::size_t> numbers;
  for (std::size_t run = 0; run < values.size(); ++run)
    combinations[run] = numbers.try_emplace({combinations[run], values[run]}, numbers.size()).first->second;
  return std::set<Value>(values.begin(), values.end()).size();
}

/// Whether every value of each axis comes with every value of the others.
bool isWholeGrid(const SweepTable& table) {
  if (table.layout().design != "grid") return false;
  std::vector<std::size_t> combinations(table.runs(), 0);
  double all = 1;
  for (const SweepAxisColumn& axis : table.layout().axes) {
    const std::size_t values = axis.numeric ? splitBy(table.numbers(axis.name), combinations)
                                            : splitBy(table.texts(axis.name), combinations);
    all *= static_cast<double>(values);
  }
  const std::set<std::size_t> found(combinations.begin(), combinations.end());
  return static_cast<double>(found.size()) == all;
}

PageJson axesJson(const SweepTable& table, const std::vector<std::size_t>& runs) {
  PageJson axes = PageJson::array();
  for (const SweepAxisColumn& axis : table.layout().axes) {
    // Texts hold their numbers as the scenario has them: the unit stays in their name.
    PageJson json = {{"name", axis.name},
                     {"path", axis.path},
                     {"label", axis.numeric ? withoutUnit(axis.name) : axis.name},
                     {"unit", axis.numeric ? summaryUnit(axis.name) : "1"},
                     {"numeric", axis.numeric}};
    if (axis.numeric) {
      const std::vector<double> values = picked(table.numbers(axis.name), runs);
      const PageJson levels = packedLevels(values, most_levels);
      if (levels.is_null())
        json["data"] = packedNumbers(values);
      else
        json["levels"] = levels;
    } else {
      json["levels"] = packedTexts(table.texts(axis.name), runs);
    }
    axes.push_back(json);
  }
  return axes;
}

PageJson metricsJson(const SweepTable& table, const std::vector<std::size_t>& runs) {
  PageJson metrics = PageJson::array();
  for (const SweepMetric& metric : table.layout().metrics)
    metrics.push_back({{"name", metric.name},
                       {"label", withoutUnit(metric.name)},
                       {"unit", summaryUnit(metric.name)},
                       {"data", packedNumbers(picked(table.numbers(metric.name), runs))}});
  return metrics;
}

std::vector<std::string> namesOf(const std::vector<RunEnd>& ends) {
  std::vector<std::string> names;
  for (const RunEnd end : ends) names.push_back(nameOf(end));
  return names;
}

/// [[pipeline, status, runs]], of all runs, in the order of the names.
PageJson countsJson(const SweepEnds& ends) {
  std::map<std::pair<std::string, std::string>, std::size_t> counts;
  for (std::size_t run = 0; run < ends.ends.size(); ++run)
    ++counts[{ends.pipelines[run], nameOf(ends.ends[run])}];
  PageJson json = PageJson::array();
  for (const auto& [key, count] : counts) json.push_back({key.first, key.second, count});
  return json;
}

/// The best fits, then the examples of failures: places in `runs`.
std::vector<std::size_t> curvesFirst(const SweepTable& table, const std::vector<std::size_t>& runs,
                                     const PageJson& failures) {
  std::vector<std::size_t> first;
  const std::vector<SweepMetric>& metrics = table.layout().metrics;
  if (std::any_of(metrics.begin(), metrics.end(), [](const auto& metric) { return metric.name == misfit; })) {
    const std::vector<double> misfits = table.numbers(misfit);
    for (std::size_t place = 0; place < runs.size(); ++place)
      if (!std::isnan(misfits[runs[place]])) first.push_back(place);
    std::stable_sort(first.begin(), first.end(),
                     [&](std::size_t a, std::size_t b) { return misfits[runs[a]] < misfits[runs[b]]; });
    first.resize(std::min(first.size(), best_fits));
  }
  for (const PageJson& failure : failures) {
    for (const std::size_t run : failure.at("examples")) {
      const auto at = std::lower_bound(runs.begin(), runs.end(), run);
      if (at != runs.end() && *at == run) first.push_back(static_cast<std::size_t>(at - runs.begin()));
    }
  }
  return first;
}

PageJson provenanceJson(const Provenance& provenance) {
  PageJson json = PageJson::array();
  for (const auto& [name, value] : provenance) json.push_back({name, value});
  return json;
}

ShownRuns describeShown(const SweepTable& table, const std::vector<std::size_t>& runs,
                        const PageJson& pipelines, const SweepEnds& ends) {
  ShownRuns shown;
  shown.runs = runs;
  const std::vector<std::string> names = picked(ends.pipelines, runs);
  for (const std::string& name : names)
    shown.pipeline.push_back(static_cast<std::size_t>(
        std::find(pipelines.begin(), pipelines.end(), PageJson(name)) - pipelines.begin()));
  for (const std::size_t run : runs) shown.good.push_back(ends.ends[run] == RunEnd::ok);
  shown.first = curvesFirst(table, runs, failuresJson(ends));
  return shown;
}

}  // namespace

PageJson sweepPage(const std::filesystem::path& file, const std::string& program) {
  const SweepTable table(file);
  const SweepTableLayout& layout = table.layout();
  const std::size_t columns = std::max<std::size_t>(1, layout.axes.size() + layout.metrics.size());
  const std::vector<std::size_t> runs =
      shownRuns(table.runs(), std::min(most_runs, std::max<std::size_t>(100, most_numbers / columns)));
  const SweepEnds ends = sweepEnds(table);
  const PageJson packed_pipelines = packedTexts(ends.pipelines, runs);
  const bool all = runs.size() == table.runs();
  PageJson page = {{"kind", "sweep"},
                   {"title", layout.title},
                   {"description", layout.description},
                   {"file", file.filename().string()},
                   {"program", program},
                   {"design", layout.design},
                   {"whole_grid", isWholeGrid(table)},
                   {"complete", table.complete()},
                   {"total", table.runs()},
                   {"shown", runs.size()},
                   {"counts", countsJson(ends)},
                   {"numbers", all ? PageJson() : packedNumbers({runs.begin(), runs.end()})},
                   {"point", packedNumbers(picked(table.numbers("point"), runs))},
                   {"repeat", packedNumbers(picked(table.numbers("repeat"), runs))},
                   {"pipeline", packed_pipelines},
                   {"status", packedTexts(namesOf(ends.ends), runs)},
                   {"detail", packedTexts(table.texts("status_detail"), runs)},
                   {"files", packedTexts(table.texts("file"), runs)},
                   {"axes", axesJson(table, runs)},
                   {"metrics", metricsJson(table, runs)},
                   {"failures", failuresJson(ends)},
                   {"reasons", packedCodes(picked(ends.reasons, runs))}};
  page["curves"] = sweepCurves(table, describeShown(table, runs, packed_pipelines.at("values"), ends));
  page["source"] = layout.sweep_source;
  page["provenance"] = provenanceJson(layout.provenance);
  return page;
}

}  // namespace fissure
