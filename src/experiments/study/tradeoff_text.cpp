#include "study/tradeoff_text.h"

#include <fmt/core.h>

#include <cmath>

#include "table/sweep_names.h"
#include "text/units.h"

namespace fissure {

namespace {

std::string shortNumber(double value) {
  if (!std::isfinite(value)) return "-";
  return std::abs(value) >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// Median with quartiles; these are left out of a single value.
std::string spreadText(const Spread& spread) {
  if (spread.count == 0) return "-";
  if (spread.count == 1) return shortNumber(spread.median);
  return fmt::format("{} ({} to {})", shortNumber(spread.median), shortNumber(spread.low),
                     shortNumber(spread.high));
}

/// Lengths are shown in millimetres.
std::string columnUnit(ErrorQuantity quantity) {
  return unitOf(quantity) == "m" ? "mm" : unitOf(quantity);
}

std::string errorText(double error, ErrorQuantity quantity) {
  return shortNumber(unitOf(quantity) == "m" ? 1e3 * error : error);
}

/// Why a setting is not judged; empty where it is.
std::string remarkOf(const JudgedSetting& setting, const TradeoffStudy& study, const TradeoffResult& result) {
  if (setting.status.end != RunEnd::ok)
    return nameOf(setting.status.end) +
           (setting.status.detail.empty() ? "" : " (" + setting.status.detail + ")");
  if (setting.front) return "front";
  for (std::size_t e = 0; e < study.errors.size(); ++e) {
    const JudgedReference* reference = result.referenceOf(setting.pipeline, e);
    if (reference && reference->refinement.refused.empty() && std::isnan(setting.errors[e]))
      return fmt::format("{} not measured", nameOf(study.errors[e].quantity));
  }
  return "";
}

}  // namespace

std::vector<std::vector<std::string>> settingRows(const TradeoffStudy& study, const TradeoffResult& result) {
  std::vector<std::vector<std::string>> rows(1);
  rows[0].emplace_back("run");
  for (const std::string& name : sweepAxisNames(result.paths, {})) rows[0].push_back(name);
  for (const char* name : {"us per ms", "p99 us", "MiB"}) rows[0].emplace_back(name);
  for (const StudyError& error : study.errors)
    rows[0].push_back(fmt::format("{} {}", nameOf(error.quantity), columnUnit(error.quantity)));
  rows[0].emplace_back("weighed");
  rows[0].emplace_back("");
  for (const JudgedSetting& setting : result.settings) {
    std::vector<std::string>& row = rows.emplace_back();
    row.push_back(setting.pipeline);
    row.insert(row.end(), setting.values.begin(), setting.values.end());
    row.push_back(spreadText(setting.cost.us_per_ms));
    row.push_back(shortNumber(setting.cost.p99_us_per_step.median));
    row.push_back(shortNumber(setting.cost.memory_mib.median));
    for (std::size_t e = 0; e < study.errors.size(); ++e)
      row.push_back(errorText(setting.errors[e], study.errors[e].quantity));
    row.push_back(shortNumber(setting.score));
    row.push_back(remarkOf(setting, study, result));
  }
  return rows;
}

std::vector<std::string> referenceLines(const TradeoffStudy& study, const TradeoffResult& result) {
  std::vector<std::string> lines;
  for (const JudgedReference& reference : result.references) {
    const StudyError& error = study.errors[reference.error];
    const std::string unit = unitOf(error.quantity);
    std::string line = fmt::format("reference {}, {}: ", reference.pipeline, nameOf(error.quantity));
    if (!reference.refinement.refused.empty()) {
      lines.push_back(line + "REFUSED, " + reference.refinement.refused);
      continue;
    }
    line += "own error " + withUnit(reference.refinement.error, unit);
    line += std::isfinite(reference.refinement.order)
                ? fmt::format(", order {:.2f}", reference.refinement.order)
                : std::string(", the same at every rung");
    line += ", peak " + withUnit(reference.peak, unit);
    if (std::isfinite(reference.peak_limit))
      line += fmt::format(" ({} by Richardson)", withUnit(reference.peak_limit, unit));
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> orderLines(const TradeoffStudy& study, const TradeoffResult& result) {
  std::vector<std::string> lines;
  for (const AxisOrder& order : result.orders)
    lines.push_back(fmt::format(
        "{} of {} goes as {}^{:.2f}{}", nameOf(study.errors[order.error].quantity), order.pipeline,
        order.path.ends_with(".subdivisions") ? "width of " + order.path : order.path, order.order.median,
        order.lines > 1 ? fmt::format(" (median of {} lines, {:.2f} to {:.2f})", order.lines, order.order.low,
                                      order.order.high)
                        : ""));
  return lines;
}

}  // namespace fissure
