#include "report/page_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "measure/verdict.h"
#include "report/frames.h"
#include "report/key_numbers.h"
#include "report/plots.h"
#include "report/step_times.h"
#include "report/warnings.h"
#include "scenario/load.h"

namespace fissure {

namespace {

// Of the 2,000,000 bytes that a page may have, library, style and script take about 100,000.
constexpr std::size_t most_bytes = 1850000;
constexpr std::size_t least_for_frames = 300000;
constexpr std::size_t most_points = 70000;  ///< up to 10 bytes each

/// Even times as {start_s, step_s, count}, others as a list.
PageJson timesJson(const std::vector<double>& times_s) {
  const std::size_t count = times_s.size();
  const double start_s = count > 0 ? times_s.front() : 0;
  const double step_s = count > 1 ? (times_s.back() - start_s) / static_cast<double>(count - 1) : 0;
  bool even = true;
  for (std::size_t i = 0; i < count; ++i)
    even = even && std::abs(times_s[i] - start_s - step_s * static_cast<double>(i)) <= 1e-6 * step_s;
  if (even) return {{"start_s", start_s}, {"step_s", step_s}, {"count", count}};
  PageJson list = PageJson::array();
  for (const double time_s : times_s) list.push_back(shortNumber(time_s));
  return {{"list_s", list}, {"count", count}};
}

PageJson provenanceJson(const Provenance& provenance) {
  PageJson json = PageJson::array();
  for (const auto& [name, value] : provenance) json.push_back({name, value});
  return json;
}

/// What a table says of how a run ended, and of what its measures say.
PageJson endJson(const PipelineResult& run) {
  const Verdict verdict = verdictOf(run.summary);
  const bool finished = run.status.end == RunEnd::ok;
  std::string grade;
  if (verdict.grade == VerdictGrade::failed) grade = "bad";
  if (verdict.grade == VerdictGrade::held && finished && verdict.text != "-") grade = "good";
  return {{"status", endText(run.status.end)},
          {"finished", finished},
          {"verdict", verdict.text},
          {"grade", grade}};
}

/// The first note on what a reaction is worth, of any run.
std::string reactionNoteOf(const std::vector<PipelineResult>& runs) {
  for (const PipelineResult& run : runs)
    if (std::string note = reactionNote(run.summary); !note.empty()) return note;
  return "";
}

PageJson runsJson(const std::vector<ReportRun>& runs) {
  PageJson json = PageJson::array();
  for (const ReportRun& run : runs)
    json.push_back({{"name", run.result->name},
                    {"pipeline", run.result->pipeline},
                    {"precision", run.result->precision},
                    {"description", run.result->description},
                    {"end", endJson(*run.result)},
                    {"times", timesJson(run.times_s)}});
  return json;
}

/// Description and expectations of the scenario stored in `file`; that it cannot be read is a warning.
void addScenario(const ResultInfo& info, const std::filesystem::path& file, PageJson& page) {
  page["description"] = "";
  page["expectations"] = PageJson::array();
  page["scenario"] = info.scenario_resolved;
  if (info.scenario_resolved.empty()) return;
  try {
    const Scenario scenario = parseStoredScenario(info.scenario_resolved, file).scenario;
    page["description"] = scenario.description;
    page["expectations"] = expectationsJson(scenario.expect, info.pipelines);
  } catch (const InputError& error) {
    page["warnings"].push_back(resultWarning(false, error.text()));
  }
}

/// The frames take what the rest leaves.
PageJson fittingFrames(const std::vector<ReportRun>& runs, const PageJson& page) {
  const std::size_t bytes = page.dump(-1, ' ', false, PageJson::error_handler_t::replace).size();
  return framesJson(runs, std::max(least_for_frames, most_bytes - std::min(most_bytes, bytes)));
}

PageJson entryJson(const FolderEntry& entry) {
  PageJson runs = PageJson::array();
  for (const PipelineResult& run : entry.info.pipelines)
    runs.push_back({{"name", run.name}, {"end", endJson(run)}, {"precision", run.precision}});
  return {{"name", entry.name},
          {"page", entry.page},
          {"problem", entry.problem},
          {"note", entry.note},
          {"title", entry.info.title},
          {"runs", runs},
          {"numbers", folderNumbersJson(entry.info.pipelines)}};
}

}  // namespace

PageJson resultPage(const std::filesystem::path& file, const std::string& program, const std::string& video) {
  const ResultInfo info = readResultInfo(file);
  if (!info.complete)
    throw InputError(inFile(file),
                     "not complete, expected a finished result (fissure salvage makes one of a part)");
  const std::vector<ReportRun> runs = openRuns(file, info);
  PageJson page = {{"kind", "result"},
                   {"title", info.title},
                   {"file", file.filename().string()},
                   {"program", program},
                   {"warnings", warningsJson(info, runs)},
                   {"runs", runsJson(runs)},
                   {"key_numbers", keyNumbersJson(info.pipelines)},
                   {"reaction_note", reactionNoteOf(info.pipelines)},
                   {"all_numbers", allNumbersJson(info.pipelines)},
                   {"step_times", stepTimesJson(file, info, runs)},
                   {"provenance", provenanceJson(info.provenance)}};
  addScenario(info, file, page);
  page["plots"] = plotsJson(runs, most_points);
  page["frames"] = fittingFrames(runs, page);
  page["video"] = video;
  return page;
}

PageJson folderPage(const std::string& folder, const std::string& program,
                    const std::vector<FolderEntry>& entries) {
  PageJson results = PageJson::array();
  for (const FolderEntry& entry : entries) results.push_back(entryJson(entry));
  return {{"kind", "folder"},
          {"title", folder},
          {"program", program},
          {"columns", folderColumnsJson()},
          {"results", results}};
}

}  // namespace fissure
