#include "report/warnings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "measure/verdict.h"
#include "report/summary_values.h"

namespace fissure {

namespace {

struct Warning {
  bool serious = false;
  std::string text;
};

/// What summary values whose names end so mean, where they are above 0.
struct Counted {
  std::string_view ending;
  const char* text;  ///< {}: the count; []: what stands before the ending
  bool serious = false;
};

constexpr Counted counted[] = {
    {"passed_through_samples", "{} tool samples went into the tissue on one side and out of it on another",
     true},
    {"max_inverted_triangles",
     "up to {} tissue triangles are turned inside out or folded over: depth can hide there, so that the "
     "penetration depth says too little",
     true},
    {"_coupling_saturated_steps",
     "saturated: in {} steps the coupling of [] asks for more force than its device gives"},
    {"_replay_gaps", "the log that [] replays has {} gaps: no motion is known there"},
    {"_replay_held_samples",
     "the log that [] replays has {} held samples: the device stood still, or repeated "
     "its last place"},
    {"_replay_jumps", "the log that [] replays has {} jumps, farther in one sample than a hand moves"},
    {"_replay_fast_steps", "the log that [] replays has {} steps faster than jump_speed_m_s: no hand is"},
    {"_replay_rows_beyond_reason", "{} rows of the log that [] replays have numbers that are no measurement"},
    {"_replay_dropped_rows", "{} rows of the log that [] replays were dropped"},
    {"_replay_repeated_rows", "{} rows of the log that [] replays repeat a time"},
    {"_replay_saturated_openings", "{} samples of the log that [] replays are beyond the opening's limits"},
};

std::string filled(const Counted& rule, const std::string& subject, const std::string& count) {
  std::string text = rule.text;
  if (const std::size_t at = text.find("{}"); at != std::string::npos) text.replace(at, 2, count);
  if (const std::size_t at = text.find("[]"); at != std::string::npos) text.replace(at, 2, subject);
  return text;
}

void addCounted(const Summary& summary, std::vector<Warning>& warnings) {
  for (const SummaryValue& value : summary) {
    const auto count = numberOf(value);
    if (!count || !(*count > 0)) continue;
    for (const Counted& rule : counted) {
      if (!value.name.ends_with(rule.ending)) continue;
      const std::string subject = value.name.substr(0, value.name.size() - rule.ending.size());
      warnings.push_back(
          {rule.serious, filled(rule, subject, std::to_string(static_cast<long long>(*count)))});
    }
  }
}

void addGround(const Summary& summary, std::vector<Warning>& warnings) {
  const SummaryValue* value = findValue(summary, "max_ground_depth_m");
  const double depth_m = value ? numberOf(*value).value_or(0) : 0;
  if (!(depth_m > kHeldDepth_m)) return;
  warnings.push_back(
      {false,
       fmt::format(
           "tissue stands up to {:.2f} mm below the ground: part of what the tool pushes away goes there",
           1e3 * depth_m)});
}

void addForces(const Summary& summary, std::vector<Warning>& warnings) {
  constexpr std::string_view overflow = "force_non_finite_at_step_", saturated = "saturated_steps_";
  for (const SummaryValue& value : summary) {
    const auto number = numberOf(value);
    if (!number) continue;
    const auto count = static_cast<long long>(*number);
    if (value.name.starts_with(overflow))
      warnings.push_back({true, fmt::format("the force of law {} is not finite, first at step {}",
                                            value.name.substr(overflow.size()), count)});
    if (value.name.starts_with(saturated) && *number > 0)
      warnings.push_back(
          {false, fmt::format("saturated: by law {} {} steps are beyond the force limit of the tool's device",
                              value.name.substr(saturated.size()), count)});
  }
}

void addTexts(const Summary& summary, std::vector<Warning>& warnings) {
  for (const SummaryValue& value : summary) {
    const auto* text = std::get_if<std::string>(&value.value);
    if (!text) continue;
    if (value.name == "repairs") warnings.push_back({false, "repaired mesh: " + *text});
  }
}

/// In how many steps `is` holds for some column of a quantity, as "3 steps"; empty: in none. Where not every
/// step has a row there may be more.
std::string stepsWhere(const ReportRun& run, const std::string& name, std::size_t first, std::size_t stride,
                       const std::function<bool(double)>& is) {
  const StoredQuantity* quantity = run.reader.find(name);
  if (!quantity || quantity->row_axis != "time") return {};
  const std::vector<double> values = run.reader.all(*quantity);
  std::size_t count = 0;
  for (std::size_t i = first; i < values.size(); i += stride) count += is(values[i]) ? 1 : 0;
  if (count == 0) return {};
  const SummaryValue* steps = findValue(run.result->summary, "steps");
  const bool thinned = steps && numberOf(*steps).value_or(0) >= static_cast<double>(run.times_s.size());
  return (thinned ? "at least " : "") + std::to_string(count) + (count == 1 ? " step" : " steps");
}

void addSeries(const ReportRun& run, std::vector<Warning>& warnings) {
  const auto positive = [](double value) { return value > 0; };
  if (const std::string steps =
          stepsWhere(run, "penetration_depth", 0, 1, [](double v) { return !std::isfinite(v); });
      !steps.empty())
    warnings.push_back({true, fmt::format("the penetration depth of {} is no number", steps)});
  if (const std::string steps = stepsWhere(run, "capped_count", 0, 1, positive); !steps.empty())
    warnings.push_back(
        {false, fmt::format("capped: in {} a contact's displacement hit the limit of one step", steps)});
  const StoredQuantity* clamped = run.reader.find("adhesion_clamped");
  if (!clamped || clamped->axes.size() != 1) return;
  const StoredAxis& laws = clamped->axes.front();
  for (std::size_t law = 0; law < laws.length; ++law)
    if (const std::string steps = stepsWhere(run, "adhesion_clamped", law, laws.length, positive);
        !steps.empty())
      warnings.push_back(
          {false,
           fmt::format("clamped: in {} law {} would have pulled on some triangles, and was set to 0 there",
                       steps, law < laws.labels.size() ? laws.labels[law] : std::to_string(law))});
}

std::vector<Warning> warningsOf(const ReportRun& run) {
  std::vector<Warning> warnings;
  const PipelineResult& result = *run.result;
  if (result.status.end != RunEnd::ok)
    warnings.push_back({true, nameOf(result.status.end) +
                                  (result.status.detail.empty() ? "" : ": " + result.status.detail)});
  if (run.times_s.empty()) warnings.push_back({true, "it left no series: nothing of it can be plotted"});
  for (const Remark& remark : remarksOf(result.summary)) warnings.push_back({remark.serious, remark.text});
  addGround(result.summary, warnings);
  addForces(result.summary, warnings);
  addCounted(result.summary, warnings);
  addSeries(run, warnings);
  addTexts(result.summary, warnings);
  return warnings;
}

}  // namespace

PageJson resultWarning(bool serious, const std::string& text) {
  return {{"serious", serious}, {"runs", PageJson::array()}, {"text", text}};
}

PageJson warningsJson(const ResultInfo& info, const std::vector<ReportRun>& runs) {
  std::vector<PageJson> all;
  if (info.salvaged) all.push_back(resultWarning(true, "salvaged from a run that did not finish"));
  if (info.reference)
    all.push_back(resultWarning(false, "a reference: it holds only a few rows of each series"));
  if (info.pipelines.empty()) all.push_back(resultWarning(true, "there is no run in this result"));
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (const Warning& warning : warningsOf(runs[r])) {
      const auto known = std::find_if(all.begin(), all.end(), [&](const PageJson& json) {
        return json["text"] == warning.text && !json["runs"].empty();
      });
      if (known == all.end())
        all.push_back({{"serious", warning.serious}, {"runs", {r}}, {"text", warning.text}});
      else
        (*known)["runs"].push_back(r);
    }
  }
  std::stable_partition(all.begin(), all.end(), [](const PageJson& json) { return json["serious"]; });
  return all;
}

}  // namespace fissure
