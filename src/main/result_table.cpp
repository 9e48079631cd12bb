#include "main/result_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace fissure {

namespace {

struct Column {
  std::array<std::string_view, 3> header;  ///< two words and the unit
  std::string_view quantity;               ///< in the summary
  double scale;                            ///< from the summary's unit to the table's
  const char* format;
};

constexpr std::array<Column, 11> columns = {{
    {{"worst", "depth", "mm"}, "max_penetration_depth_m", 1e3, "%.3f"},
    {{"final", "depth", "mm"}, "final_penetration_depth_m", 1e3, "%.3f"},
    {{"passed", "through", "samples"}, "passed_through_samples", 1, "%.0f"},
    {{"inside-", "out tri-", "angles"}, "max_inverted_triangles", 1, "%.0f"},
    {{"peak", "force", "N"}, "max_force_N", 1, "%.3f"},
    {{"force", "rough-", "ness"}, "force_roughness", 1, "%.3g"},
    {{"", "contacts", ""}, "contacts_total", 1, "%.0f"},
    {{"mean", "step", "us"}, "timing/mean_step_us", 1, "%.1f"},
    {{"p99", "step", "us"}, "timing/p99_step_us", 1, "%.1f"},
    {{"collision", "share", "%"}, "timing/collision_share", 1e2, "%.1f"},
    {{"real-time", "factor", ""}, "timing/real_time_factor", 1, "%.3g"},
}};

std::string number(double value, const char* format) {
  if (std::isnan(value)) return "nan";
  std::array<char, 64> text = {};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string cell(const Column& column, const Summary& summary) {
  for (const SummaryValue& value : summary) {
    if (value.name != column.quantity) continue;
    if (const double* real = std::get_if<double>(&value.value))
      return number(*real * column.scale, column.format);
    if (const long long* count = std::get_if<long long>(&value.value))
      return number(static_cast<double>(*count) * column.scale, column.format);
    return std::get<std::string>(value.value);
  }
  return "-";
}

using Row = std::vector<std::string>;

/// The first two columns to the left, numbers to the right; no blanks at the ends of lines.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string blanks(widths[c] - row[c].size(), ' ');
      line += (c > 0 ? "  " : "") + (c < 2 ? row[c] + blanks : blanks + row[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string resultTable(const std::vector<PipelineResult>& pipelines) {
  std::vector<Row> rows;
  for (std::size_t line = 0; line < 3; ++line) {
    Row row = {line == 0 ? "pipeline" : "", line == 0 ? "status" : ""};
    for (const Column& column : columns) row.emplace_back(column.header[line]);
    rows.push_back(row);
  }
  std::string details;
  for (const PipelineResult& pipeline : pipelines) {
    Row row = {pipeline.name, pipeline.status.status};
    for (const Column& column : columns) row.push_back(cell(column, pipeline.summary));
    rows.push_back(row);
    if (pipeline.status.status != "ok")
      details += pipeline.name + ": " + pipeline.status.status + ": " + pipeline.status.detail + "\n";
  }
  return aligned(rows) + details;
}

std::string summaryText(const SummaryValue& value) {
  if (const std::string* text = std::get_if<std::string>(&value.value)) return *text;
  if (const long long* count = std::get_if<long long>(&value.value)) return std::to_string(*count);
  std::array<char, 64> text = {};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), std::get<double>(value.value));
  return {text.data(), end.ptr};
}

}  // namespace fissure
