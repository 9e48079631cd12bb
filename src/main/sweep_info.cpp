#include "main/sweep_info.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "main/text_table.h"
#include "text/scalars.h"
#include "text/summary_unit.h"

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;

/// How many runs ended in which way, by name, of each pipeline in the order of the table.
std::vector<std::pair<std::string, std::map<std::string, std::size_t>>> endsOf(const SweepTable& table) {
  const std::vector<std::string> pipelines = table.texts("pipeline");
  const std::vector<RunEnd> run_ends = table.ends();
  std::vector<std::pair<std::string, std::map<std::string, std::size_t>>> ends;
  for (std::size_t run = 0; run < table.runs(); ++run) {
    auto own = std::find_if(ends.begin(), ends.end(),
                            [&](const auto& known) { return known.first == pipelines[run]; });
    if (own == ends.end()) own = ends.insert(ends.end(), {pipelines[run], {}});
    ++own->second[nameOf(run_ends[run])];
  }
  return ends;
}

struct AxisEnds {
  std::size_t values = 0;
  std::string from, to;
};

AxisEnds endsOf(const SweepTable& table, const SweepAxisColumn& axis) {
  if (table.runs() == 0) return {};
  if (!axis.numeric) {
    std::vector<std::string> texts = table.texts(axis.name);
    const AxisEnds ends{0, texts.front(), texts.back()};
    std::sort(texts.begin(), texts.end());
    const auto values = std::unique(texts.begin(), texts.end()) - texts.begin();
    return {static_cast<std::size_t>(values), ends.from, ends.to};
  }
  std::vector<double> numbers = table.numbers(axis.name);
  std::sort(numbers.begin(), numbers.end());
  const AxisEnds ends{0, formatReal(numbers.front()), formatReal(numbers.back())};
  const auto values = std::unique(numbers.begin(), numbers.end()) - numbers.begin();
  return {static_cast<std::size_t>(values), ends.from, ends.to};
}

std::string withUnitOf(const std::string& name) {
  const std::string unit = summaryUnit(name);
  return unit == "1" ? name : name + " (" + unit + ")";
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += "  " + name + "\n";
  return text.empty() ? "  none\n" : text;
}

}  // namespace

std::string sweepInfoText(const SweepTable& table) {
  const SweepTableLayout& layout = table.layout();
  std::string text =
      fmt::format("{}\nfissure-sweep, version 1{}\n\n{} runs, design {}\n", layout.title,
                  table.complete() ? "" : ", not complete: runs are missing", table.runs(), layout.design);
  std::vector<TextRow> rows = {{"pipeline", "status", "runs"}};
  for (const auto& [pipeline, ends] : endsOf(table))
    for (const auto& [status, count] : ends) rows.push_back({pipeline, status, std::to_string(count)});
  text += "\n" + alignedText(rows, 2);
  rows = {{"axis", "path", "values", "from", "to"}};
  for (const SweepAxisColumn& axis : layout.axes) {
    const AxisEnds ends = endsOf(table, axis);
    rows.push_back({axis.name, axis.path, std::to_string(ends.values), ends.from, ends.to});
  }
  text += "\n" + alignedText(rows, 2);
  std::vector<std::string> metrics, curves;
  for (const SweepMetric& metric : layout.metrics) metrics.push_back(withUnitOf(metric.name));
  for (const CurveQuantity& curve : layout.curves)
    curves.push_back(fmt::format("{} ({}), {} instants{}", curve.name, curve.units,
                                 layout.curve_time_s.size(), curve.per_law ? ", each law" : ""));
  text += fmt::format("\nquantities\n{}\ncurves\n{}", listed(metrics), listed(curves));
  rows.clear();
  for (const auto& [name, value] : layout.provenance) rows.push_back({"  " + name, value});
  return text + "\nprovenance\n" + alignedText(rows, 2);
}

Json sweepInfoJson(const std::filesystem::path& file, const SweepTable& table) {
  const SweepTableLayout& layout = table.layout();
  Json pipelines = Json::object(), axes = Json::array(), provenance = Json::object();
  for (const auto& [pipeline, ends] : endsOf(table)) pipelines[pipeline] = ends;
  for (const SweepAxisColumn& axis : layout.axes) {
    const AxisEnds ends = endsOf(table, axis);
    axes.push_back({{"name", axis.name},
                    {"path", axis.path},
                    {"numeric", axis.numeric},
                    {"values", ends.values},
                    {"from", ends.from},
                    {"to", ends.to}});
  }
  Json metrics = Json::array(), curves = Json::array();
  for (const SweepMetric& metric : layout.metrics) metrics.push_back(metric.name);
  for (const CurveQuantity& curve : layout.curves) curves.push_back(curve.name);
  for (const auto& [name, value] : layout.provenance) provenance[name] = value;
  return {{"file", file.string()},     {"title", layout.title},
          {"format", "fissure-sweep"}, {"complete", table.complete()},
          {"design", layout.design},   {"runs", table.runs()},
          {"pipelines", pipelines},    {"axes", axes},
          {"laws", layout.laws},       {"quantities", metrics},
          {"curves", curves},          {"provenance", provenance}};
}

}  // namespace fissure
