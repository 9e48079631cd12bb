#include "main/comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "text/scalars.h"

namespace fissure {

namespace {

const PipelineResult* findRun(const ResultInfo& info, const std::string& name) {
  for (const PipelineResult& run : info.pipelines)
    if (run.name == name) return &run;
  return nullptr;
}

/// The run that was named, or the one that goes with the name on the other side.
const PipelineResult& chooseRun(const ResultChoice& choice, const ResultInfo& info,
                                const std::string& other) {
  const std::string& name = choice.run.empty() ? other : choice.run;
  if (const PipelineResult* found = findRun(info, name)) return *found;
  if (choice.run.empty() && info.pipelines.size() == 1) return info.pipelines.front();
  std::string known;
  for (const PipelineResult& run : info.pipelines) known += (known.empty() ? "" : ", ") + run.name;
  throw InputError(inFile(choice.file), fmt::format("has no run \"{}\", expected one of {}", name, known));
}

void noteScenarios(const ResultInfo& a, const ResultInfo& b, std::vector<std::string>& notes) {
  std::istringstream text_a(a.scenario_resolved), text_b(b.scenario_resolved);
  std::string line_a, line_b;
  for (int line = 1;; ++line) {
    const bool more_a = static_cast<bool>(std::getline(text_a, line_a));
    const bool more_b = static_cast<bool>(std::getline(text_b, line_b));
    if (!more_a && !more_b) return;
    if (more_a == more_b && line_a == line_b) continue;
    const auto shown = [](bool there, const std::string& text) {
      return there ? inQuotes(text.substr(std::min(text.find_first_not_of(' '), text.size())))
                   : std::string("its end");
    };
    notes.push_back(fmt::format("the resolved scenarios differ, first in line {}: {} against {}", line,
                                shown(more_a, line_a), shown(more_b, line_b)));
    return;
  }
}

}  // namespace

ResultChoice parseChoice(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::error_code ignored;
  if (colon == std::string::npos || std::filesystem::exists(text, ignored)) return {text, ""};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

bool ResultComparison::agrees() const {
  return problems.empty() &&
         std::all_of(runs.begin(), runs.end(), [](const RunComparison& run) { return run.agrees(); });
}

ResultComparison compareResults(const ResultChoice& a, const ResultInfo& info_a, const ResultChoice& b,
                                const ResultInfo& info_b, const CompareSettings& settings) {
  ResultComparison comparison{a, b, {}, {}, {}};
  const auto compare = [&](const PipelineResult& run_a, const PipelineResult& run_b) {
    comparison.runs.push_back(compareRuns({a.file, &info_a, &run_a}, {b.file, &info_b, &run_b}, settings));
  };
  noteScenarios(info_a, info_b, comparison.notes);
  if (!a.run.empty() || !b.run.empty()) {
    const std::string& name = a.run.empty() ? b.run : a.run;
    compare(chooseRun(a, info_a, name), chooseRun(b, info_b, name));
    return comparison;
  }
  for (const PipelineResult& run : info_a.pipelines) {
    if (const PipelineResult* partner = findRun(info_b, run.name))
      compare(run, *partner);
    else
      comparison.problems.push_back("run " + run.name + " is missing in B");
  }
  for (const PipelineResult& run : info_b.pipelines)
    if (!findRun(info_a, run.name)) comparison.problems.push_back("run " + run.name + " is missing in A");
  if (comparison.runs.empty() && comparison.problems.empty())
    comparison.problems.push_back("there is no run");
  return comparison;
}

}  // namespace fissure
