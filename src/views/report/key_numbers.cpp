#include "report/key_numbers.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/compare_runs.h"
#include "compare/expectations.h"
#include "report/summary_values.h"
#include "text/scalars.h"
#include "text/units.h"

namespace fissure {

namespace {

struct Row {
  std::string name;  ///< of the summary value
  std::string label;
  std::string unit;
  double scale = 1;  ///< from the summary's unit
  const char* format = "{:.0f}";
  bool should_be_zero = false;
};

PageJson cell(const Row& row, const PipelineResult& run) {
  const SummaryValue* value = findValue(run.summary, row.name);
  const auto number = value ? numberOf(*value) : std::nullopt;
  if (!number || (std::isnan(*number) && mayBeMissing("summary/" + row.name)))
    return {{"text", "–"}, {"bad", false}};
  return {{"text", numberText(row.format, *number * row.scale)},
          {"bad", std::isnan(*number) || (row.should_be_zero && *number != 0)}};
}

/// In the order of the runs, each once.
std::vector<std::string> namesOf(const std::vector<PipelineResult>& runs) {
  std::vector<std::string> names;
  for (const PipelineResult& run : runs)
    for (const SummaryValue& value : run.summary)
      if (std::find(names.begin(), names.end(), value.name) == names.end()) names.push_back(value.name);
  return names;
}

/// The part of `name` between `start` and `end`; empty where it is not so built.
std::string between(const std::string& name, const std::string& start, const std::string& end) {
  if (name.size() <= start.size() + end.size() || !name.starts_with(start) || !name.ends_with(end)) return "";
  return name.substr(start.size(), name.size() - start.size() - end.size());
}

std::vector<Row> rowsFor(const std::vector<PipelineResult>& runs) {
  const std::vector<std::string> names = namesOf(runs);
  std::vector<Row> rows = {
      {"max_penetration_depth_m", "Worst penetration", "mm", 1e3, "{:.3f}"},
      {"max_inversion_aware_depth_m", "The same with inverted tissue", "mm", 1e3, "{:.3f}"},
      {"final_penetration_depth_m", "Penetration at the end", "mm", 1e3, "{:.3f}"},
      {"passed_through_samples", "Tool samples passed through", "", 1, "{:.0f}", true},
      {"max_inverted_triangles", "Triangles inverted at most", "", 1, "{:.0f}", true},
      {"uncertified_steps", "Steps not proved free of overlap", "", 1, "{:.0f}", true},
      {"max_ground_depth_m", "Tissue below the ground", "mm", 1e3, "{:.3f}"},
      {"unsound_steps", "Steps with unsound tissue", "", 1, "{:.0f}", true},
  };
  for (const std::string& name : names)
    if (const std::string law = between(name, "max_force_", "_N"); !law.empty())
      rows.push_back({name, "Largest force, " + law, "N", 1, "{:.4g}"});
  for (const std::string& name : names)
    if (const std::string law = between(name, "force_roughness_", ""); !law.empty())
      rows.push_back({name, "Force roughness, " + law, "", 1, "{:.3g}"});
  for (const std::string& name : names)
    if (const std::string clamp = between(name, "", "_final_reaction_N"); !clamp.empty())
      rows.push_back({name, "Reaction at the end, " + clamp, "N", 1, "{:.4g}"});
  rows.push_back({"max_reaction_N", "Largest reaction (see below)", "N", 1, "{:.4g}"});
  rows.push_back({"first_contact_time_s", "First contact", "s", 1, "{:.3f}"});
  rows.push_back({"contact_steps", "Steps with contact", ""});
  rows.push_back({"contacts_total", "Contacts, all steps", ""});
  rows.push_back({"steps", "Steps", ""});
  rows.push_back({"timing/p50_step_us", "Step time, median", "µs", 1, "{:.0f}"});
  rows.push_back({"timing/p99_step_us", "Step time, 99 % below", "µs", 1, "{:.0f}"});
  rows.push_back({"timing/max_step_us", "Step time, longest", "µs", 1, "{:.0f}"});
  rows.push_back({"timing/real_time_factor", "Real-time factor", "", 1, "{:.3g}"});
  return rows;
}

/// What a table of many results shows of each run.
const std::vector<Row>& folderRows() {
  static const std::vector<Row> rows = {
      {"max_penetration_depth_m", "Worst penetration", "mm", 1e3, "{:.3f}"},
      {"max_inversion_aware_depth_m", "With inversion", "mm", 1e3, "{:.3f}"},
      {"passed_through_samples", "Passed through", "", 1, "{:.0f}", true},
      {"max_inverted_triangles", "Inverted triangles", "", 1, "{:.0f}", true},
      {"uncertified_steps", "Not proved", "", 1, "{:.0f}", true},
      {"max_ground_depth_m", "Below ground", "mm", 1e3, "{:.3f}"},
      {"max_force_N", "Largest force", "N", 1, "{:.4g}"},
      {"steps", "Steps", ""},
      {"timing/p99_step_us", "Step time, 99 % below", "µs", 1, "{:.0f}"},
  };
  return rows;
}

std::string valueText(const SummaryValue& value) {
  if (const std::string* text = std::get_if<std::string>(&value.value)) return *text;
  if (const long long* count = std::get_if<long long>(&value.value)) return std::to_string(*count);
  return formatReal(std::get<double>(value.value));
}

}  // namespace

PageJson keyNumbersJson(const std::vector<PipelineResult>& runs) {
  PageJson table = PageJson::array();
  for (const Row& row : rowsFor(runs)) {
    PageJson cells = PageJson::array();
    for (const PipelineResult& run : runs) cells.push_back(cell(row, run));
    const bool any =
        std::any_of(cells.begin(), cells.end(), [](const PageJson& c) { return c["text"] != "–"; });
    if (any) table.push_back({{"label", row.label}, {"unit", row.unit}, {"cells", cells}});
  }
  return table;
}

PageJson folderColumnsJson() {
  PageJson columns = PageJson::array();
  for (const Row& row : folderRows()) columns.push_back({{"label", row.label}, {"unit", row.unit}});
  return columns;
}

PageJson folderNumbersJson(const std::vector<PipelineResult>& runs) {
  PageJson table = PageJson::array();
  for (const PipelineResult& run : runs) {
    PageJson cells = PageJson::array();
    for (const Row& row : folderRows()) cells.push_back(cell(row, run));
    table.push_back(cells);
  }
  return table;
}

PageJson allNumbersJson(const std::vector<PipelineResult>& runs) {
  PageJson table = PageJson::array();
  for (const std::string& name : namesOf(runs)) {
    PageJson cells = PageJson::array();
    for (const PipelineResult& run : runs) {
      const SummaryValue* value = findValue(run.summary, name);
      cells.push_back({{"text", value ? valueText(*value) : "–"}, {"bad", false}});
    }
    table.push_back({{"label", name}, {"unit", ""}, {"cells", cells}});
  }
  return table;
}

PageJson expectationsJson(const std::vector<Expectation>& expectations,
                          const std::vector<PipelineResult>& runs) {
  PageJson json = PageJson::array();
  for (const CheckedExpectation& checked : checkExpectations(expectations, runs))
    json.push_back({{"run", checked.run},
                    {"quantity", checked.quantity},
                    {"found", checked.found},
                    {"expected", checked.expected},
                    {"holds", checked.holds}});
  return json;
}

}  // namespace fissure
