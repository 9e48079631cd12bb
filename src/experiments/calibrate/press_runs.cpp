#include "calibrate/press_runs.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "batch/batch.h"
#include "batch/provenance.h"
#include "fit/press_curve.h"
#include "process/apart.h"
#include "sweep/sweep_planning.h"
#include "sweep/sweep_results.h"
#include "sweep/sweep_session.h"
#include "sweep/sweep_state.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// The result of one entry of a scenario: where it belongs, and whether it has to be made.
struct WantedResult {
  CheckedScenario checked;
  fs::path file;
};

/// Whether `file` is there, with the run of this scenario, finished. Throws InputError where it is another
/// one's.
bool isFinished(const WantedResult& wanted) {
  if (!fs::exists(wanted.file)) return false;
  ResultInfo info;
  tryReading(wanted.file, [&] { readResultInfo(wanted.file); });
  info = readResultInfo(wanted.file);
  const auto hashes = std::find_if(info.provenance.begin(), info.provenance.end(),
                                   [](const auto& entry) { return entry.first == "input_hashes"; });
  if (info.reference || info.scenario_resolved != wanted.checked.loaded.resolved ||
      hashes == info.provenance.end() || hashes->second != inputHashes(wanted.checked.loaded))
    throw InputError(inFile(wanted.file),
                     fmt::format("is not of {} as it is now, expected another folder (--out) or no such file",
                                 wanted.checked.file.string()));
  return info.complete && std::all_of(info.pipelines.begin(), info.pipelines.end(),
                                      [](const auto& run) { return run.status.end == RunEnd::ok; });
}

std::vector<WantedResult> wantedOf(const fs::path& file, const fs::path& folder) {
  std::vector<WantedResult> wanted;
  const std::vector<PipelineSettings> entries = checkScenario(file).loaded.scenario.pipelines;
  for (const PipelineSettings& entry : entries) {
    CheckedScenario checked = checkScenario(file, {.pipelines = {entry.name}});
    checked.prepared = {};  // workers build their own
    const std::string& name = checked.loaded.scenario.name;
    const fs::path result =
        folder / (entries.size() == 1 ? name + ".h5" : fmt::format("{}-{}.h5", name, entry.name));
    wanted.push_back({std::move(checked), result});
  }
  return wanted;
}

/// Simulates into `runs`.
void runScenario(const fs::path& file, const PressOutput& output, ProgressDisplay& display, PressRuns& runs) {
  Interrupt interrupt;  // before the first file is made, so that none is left behind
  std::vector<Experiment> experiments;
  for (WantedResult& wanted : wantedOf(file, output.folder)) {
    if (isFinished(wanted))
      runs.results.push_back(wanted.file.string());
    else  // in place of one that has not come to its end, if there is one
      experiments.emplace_back(std::move(wanted.checked), wanted.file, OutputRules{.replace = true});
  }
  Batch(experiments, output.command_line, display).run(1, interrupt);
  if (interrupt.requested()) throw Interrupted();
  for (const Experiment& experiment : experiments) {
    if (!experiment.error().empty()) throw RunError(experiment.error());
    const PartResult& run = experiment.results().front();
    if (run.status.end == RunEnd::ok)
      runs.results.push_back(experiment.output().string());
    else
      runs.failures.push_back(fmt::format("{}: run {} {}: {}", file.string(), run.pipeline.name,
                                          nameOf(run.status.end), run.status.detail));
  }
}

void requireResults(const SweepSettings& sweep, const fs::path& file) {
  if (sweep.keep != SweepKeep::results)
    throw InputError(inFile(file), "keeps no result of its simulations, expected keep: results");
}

void runSweep(const fs::path& file, const PressOutput& output, ProgressDisplay& display, PressRuns& runs) {
  Interrupt interrupt;
  const fs::path folder = fs::path(output.folder) / loadSweep(file).name;
  SweepManifest manifest = planSweep(file, folder, false);
  requireResults(manifest.settings, file);
  putManifest(manifest, folder);
  const SweepPlan plan(std::move(manifest), folder);
  std::vector<std::size_t> all(plan.tasks().size());
  for (std::size_t task = 0; task < all.size(); ++task) all[task] = task;
  SweepState before(plan, folder);
  forgetLostResults(before, folder, all, ResultCheck::contents);
  std::vector<std::size_t> tasks = before.unfinished();
  if (!tasks.empty()) {
    const auto untried = static_cast<std::size_t>(std::count_if(
        tasks.begin(), tasks.end(), [&](std::size_t task) { return !before.task(task).place; }));
    SweepSession session(plan, folder, std::move(tasks), {1, untried, false, output.command_line}, display);
    session.run(interrupt);
    if (session.counts().interrupted > 0 || interrupt.requested()) throw Interrupted();
  }
  const SweepState state(plan, folder);
  for (const std::size_t task : all) {
    const SweepState::Task& made = state.task(task);
    if (made.finished && !made.file.empty())
      runs.results.push_back((folder / made.file).string());
    else
      runs.failures.push_back(fmt::format("{}: simulation {} {}: {}", file.string(), plan.tasks()[task].id,
                                          nameOf(made.status.end), made.status.detail));
  }
}

/// All that can be said against simulating and fitting `file` without simulating.
void check(const fs::path& file) {
  if (isSweepFile(file)) {
    const SweepSettings sweep = loadSweep(file);
    requireResults(sweep, file);
    requirePress(loadScenario(sweep.directory / sweep.base).scenario, sweep.directory / sweep.base);
  } else {
    requirePress(checkScenario(file).loaded.scenario, file);
  }
}

}  // namespace

bool isToSimulate(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

PressRuns pressRuns(const std::vector<std::string>& names, const PressOutput& output,
                    ProgressDisplay& display) {
  for (const std::string& name : names)
    if (isToSimulate(name)) check(name);
  PressRuns runs;
  for (const std::string& name : names) {
    if (!isToSimulate(name))
      runs.results.push_back(name);
    else if (isSweepFile(name))
      runSweep(name, output, display, runs);
    else
      runScenario(name, output, display, runs);
  }
  return runs;
}

}  // namespace fissure
