#include "study/study_sweep.h"

#include <fmt/format.h>

#include <numeric>

#include "base/error.h"
#include "files/write_file.h"
#include "process/interrupt.h"
#include "sweep/sweep_planning.h"
#include "sweep/sweep_results.h"
#include "sweep/sweep_session.h"
#include "text/scalars.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

fs::path fileOf(const fs::path& folder) {
  return folder.string() + ".yaml";
}

std::string relativeTo(const fs::path& folder, const fs::path& file) {
  return fs::weakly_canonical(fs::absolute(file))
      .lexically_relative(fs::weakly_canonical(fs::absolute(folder)))
      .generic_string();
}

std::string sweepText(const StudySweep& sweep) {
  std::string text = fmt::format(
      "# Made by fissure study.\nformat: 1\nname: {}\nbase: {}\npipelines: [{}]\nkeep: results\n", sweep.name,
      formatText(relativeTo(sweep.folder.parent_path(), sweep.base)), formatText(sweep.pipeline));
  std::vector<std::string> limits;
  if (sweep.time_s) limits.push_back("time_s: " + formatReal(*sweep.time_s));
  if (sweep.memory_mib) limits.push_back("memory_mb: " + formatReal(*sweep.memory_mib));
  if (!limits.empty()) text += fmt::format("limits: {{{}}}\n", fmt::join(limits, ", "));
  text += "axes:\n  - zip:\n";
  for (std::size_t p = 0; p < sweep.points.front().size(); ++p) {
    std::vector<std::string> values;
    for (const std::vector<Override>& point : sweep.points) values.push_back(point[p].value);
    text += fmt::format("      - path: {}\n        values: [{}]\n", formatText(sweep.points.front()[p].path),
                        fmt::join(values, ", "));
  }
  return text;
}

/// The sweep's state, without results that are gone.
SweepState stateOf(const SweepPlan& plan, const fs::path& folder) {
  SweepState state(plan, folder);
  std::vector<std::size_t> all(plan.tasks().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  forgetLostResults(state, folder, all, ResultCheck::contents);
  return state;
}

std::vector<std::size_t> untriedOf(const SweepState& state) {
  std::vector<std::size_t> tasks = state.unfinished();
  std::erase_if(tasks, [&](std::size_t task) { return state.task(task).status.end != RunEnd::missing; });
  return tasks;
}

}  // namespace

void putSweep(const StudySweep& sweep) {
  std::error_code error;
  fs::create_directories(sweep.folder.parent_path(), error);
  if (error) throw RunError(sweep.folder.parent_path().string() + ": cannot be made: " + error.message());
  replaceFile(fileOf(sweep.folder), sweepText(sweep));
  putManifest(planSweep(fileOf(sweep.folder), sweep.folder, true), sweep.folder);
}

std::size_t untriedIn(const fs::path& folder) {
  const SweepPlan plan(readManifest(folder), folder);
  return untriedOf(stateOf(plan, folder)).size();
}

void runUntried(const fs::path& folder, int slots, const std::string& command_line,
                ProgressDisplay& display) {
  Interrupt interrupt;
  const SweepPlan plan(readManifest(folder), folder);
  std::vector<std::size_t> tasks = untriedOf(stateOf(plan, folder));
  if (tasks.empty()) return;
  const std::size_t untried = tasks.size();
  SweepSession session(plan, folder, std::move(tasks), {slots, untried, false, command_line}, display);
  session.run(interrupt);
  if (session.counts().interrupted > 0 || interrupt.requested()) throw Interrupted();
}

std::vector<StudyRun> runsOf(const fs::path& folder) {
  const SweepPlan plan(readManifest(folder), folder);
  const SweepState state = stateOf(plan, folder);
  std::vector<StudyRun> runs;
  for (std::size_t i = 0; i < plan.runs(); ++i) {
    const SweepState::Task& task = state.task(plan.run(i).task);
    runs.push_back({task.status, task.file.empty() ? fs::path() : folder / task.file, task.wall_s});
  }
  return runs;
}

}  // namespace fissure
