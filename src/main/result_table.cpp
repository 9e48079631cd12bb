#include "main/result_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "compare/compare_runs.h"
#include "main/text_table.h"
#include "measure/verdict.h"
#include "text/units.h"

namespace fissure {

namespace {

struct Column {
  std::array<std::string_view, 3> header;  ///< two words and the unit
  std::string_view quantity;               ///< in the summary
  double scale;                            ///< from the summary's unit to the table's
  const char* format;
};

constexpr std::array<Column, 15> columns = {{
    {{"worst", "depth", "mm"}, "max_penetration_depth_m", 1e3, "{:.3f}"},
    {{"with in-", "version", "mm"}, "max_inversion_aware_depth_m", 1e3, "{:.3f}"},
    {{"final", "depth", "mm"}, "final_penetration_depth_m", 1e3, "{:.3f}"},
    {{"passed", "through", "samples"}, "passed_through_samples", 1, "{:.0f}"},
    {{"inside-", "out tri-", "angles"}, "max_inverted_triangles", 1, "{:.0f}"},
    {{"steps", "not", "proved"}, "uncertified_steps", 1, "{:.0f}"},
    {{"below", "ground", "mm"}, "max_ground_depth_m", 1e3, "{:.3f}"},
    {{"peak", "force", "N"}, "max_force_N", 1, "{:.3f}"},
    {{"peak re-", "action", "N"}, "max_reaction_N", 1, "{:.4g}"},
    {{"force", "rough-", "ness"}, "force_roughness", 1, "{:.3g}"},
    {{"contacts", "over all", "steps"}, "contacts_total", 1, "{:.0f}"},
    {{"mean", "step", "us"}, "timing/mean_step_us", 1, "{:.1f}"},
    {{"p99", "step", "us"}, "timing/p99_step_us", 1, "{:.1f}"},
    {{"collision", "share", "%"}, "timing/collision_share", 1e2, "{:.1f}"},
    {{"real-time", "factor", ""}, "timing/real_time_factor", 1, "{:.3g}"},
}};

std::string cell(const Column& column, const Summary& summary) {
  for (const SummaryValue& value : summary) {
    if (value.name != column.quantity) continue;
    if (const double* real = std::get_if<double>(&value.value))
      return std::isnan(*real) && mayBeMissing("summary/" + value.name)
                 ? "-"
                 : numberText(column.format, *real * column.scale);
    if (const long long* count = std::get_if<long long>(&value.value)) return std::to_string(*count);
    return std::get<std::string>(value.value);
  }
  return "-";
}

/// A line for each law whose force overflowed, though the run itself is sound.
std::string overflows(const PipelineResult& pipeline) {
  constexpr std::string_view name = "force_non_finite_at_step_";
  std::string text;
  for (const SummaryValue& value : pipeline.summary)
    if (value.name.starts_with(name))
      text += fmt::format("{}: the force of law {} is not finite, first at step {}\n", pipeline.name,
                          value.name.substr(name.size()), summaryText(value));
  return text;
}

/// A line for each remark, after the names of the runs that it is about.
std::string remarkLines(const std::vector<PipelineResult>& pipelines) {
  std::vector<std::pair<std::string, std::string>> lines;  // remark, runs
  for (const PipelineResult& pipeline : pipelines) {
    for (const Remark& remark : remarksOf(pipeline.summary)) {
      const auto known = std::find_if(lines.begin(), lines.end(),
                                      [&](const auto& line) { return line.first == remark.text; });
      if (known == lines.end())
        lines.emplace_back(remark.text, pipeline.name);
      else
        known->second += ", " + pipeline.name;
    }
  }
  std::string text;
  for (const auto& [remark, runs] : lines) text += fmt::format("{}: {}\n", runs, remark);
  for (const PipelineResult& pipeline : pipelines)
    if (const std::string note = reactionNote(pipeline.summary); !note.empty()) return text + note + "\n";
  return text;
}

}  // namespace

std::string resultTable(const std::vector<PipelineResult>& pipelines) {
  std::vector<TextRow> rows;
  for (std::size_t line = 0; line < 3; ++line) {
    TextRow row = {line == 0 ? "pipeline" : "", line == 0 ? "end" : ""};
    for (const Column& column : columns) row.emplace_back(column.header[line]);
    row.emplace_back(line == 0 ? "verdict" : "");
    rows.push_back(row);
  }
  std::string details;
  for (const PipelineResult& pipeline : pipelines) {
    TextRow row = {pipeline.name, endText(pipeline.status.end)};
    for (const Column& column : columns) row.push_back(cell(column, pipeline.summary));
    row.push_back(verdictOf(pipeline.summary).text);
    rows.push_back(row);
    if (pipeline.status.end != RunEnd::ok)
      details +=
          fmt::format("{}: {}: {}\n", pipeline.name, nameOf(pipeline.status.end), pipeline.status.detail);
    details += overflows(pipeline);
  }
  return alignedText(rows, 2, true) + details + remarkLines(pipelines);
}

std::string summaryTable(const std::vector<PipelineResult>& pipelines) {
  std::vector<TextRow> rows = {{"summary"}};
  for (const PipelineResult& pipeline : pipelines) {
    rows.front().push_back(pipeline.name);
    for (const SummaryValue& value : pipeline.summary) {
      const bool known =
          std::any_of(rows.begin(), rows.end(), [&](const TextRow& row) { return row[0] == value.name; });
      if (!known && !std::holds_alternative<std::string>(value.value)) rows.push_back({value.name});
    }
  }
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const std::string name = row->front();
    const Column column{.header = {}, .quantity = name, .scale = 1, .format = "{:.6g}"};
    for (const PipelineResult& pipeline : pipelines) row->push_back(cell(column, pipeline.summary));
  }
  std::string texts;
  for (const PipelineResult& pipeline : pipelines)
    for (const SummaryValue& value : pipeline.summary)
      if (const std::string* text = std::get_if<std::string>(&value.value))
        texts += fmt::format("{}: {}: {}\n", pipeline.name, value.name, *text);
  return alignedText(rows, 1) + texts;
}

std::string summaryText(const SummaryValue& value) {
  if (const std::string* text = std::get_if<std::string>(&value.value)) return *text;
  if (const long long* count = std::get_if<long long>(&value.value)) return std::to_string(*count);
  std::array<char, 64> text = {};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), std::get<double>(value.value));
  return {text.data(), end.ptr};
}

}  // namespace fissure
