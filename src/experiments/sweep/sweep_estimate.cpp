#include "sweep/sweep_estimate.h"

#include <algorithm>
#include <cmath>

#include "batch/engine_program.h"
#include "batch/pilot_runs.h"
#include "check/run_plan.h"
#include "files/temporary_folder.h"
#include "files/write_file.h"
#include "sweep/sweep_session.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr int pilot_of = 10;  ///< one step of so many
constexpr double longest_pilot_s = 20;

std::optional<double> meanOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::optional<double> timeSome(const SweepPlan& plan, const std::vector<std::size_t>& tasks,
                               Interrupt& interrupt) {
  const TemporaryFolder scratch;
  std::vector<WorkerTask> some;
  for (const std::size_t at : {std::size_t{0}, tasks.size() / 2, tasks.size() - 1}) {
    const SweepTask& task = plan.tasks()[tasks[at]];
    const fs::path order = scratch.path() / std::to_string(some.size());
    writeFile(order, orderText(orderOf(plan, task)));
    some.push_back({engineProgram(plan.precision(task)),
                    {"--order", order.string(), "--record", order.string() + ".record"},
                    longest_pilot_s,
                    plan.manifest().settings.limits.memory_mib.value_or(0),
                    scratch.path()});
    if (plan.keepsResults())
      some.back().arguments.insert(some.back().arguments.end(), {"--part", order.string() + ".part"});
  }
  std::vector<double> times_s;
  for (const PilotRun& pilot : runPilots(some, pilot_of, scratch.path(), interrupt)) {
    if (pilot.forecast) times_s.push_back(pilot.forecast->run_s);
    if (pilot.status.end == RunEnd::timeout && pilot.progress.step > 0)
      times_s.push_back(pilot_of * pilot.wall_s * static_cast<double>(pilot.progress.steps) /
                        static_cast<double>(pilot.progress.step));
  }
  return meanOf(times_s);
}

double bytesOf(const SweepPlan& plan, const std::vector<std::size_t>& tasks) {
  const SweepManifest& manifest = plan.manifest();
  const std::size_t laws = plan.base().scenario.force.size();
  double columns = 70;  // about as many numbers has a summary
  if (manifest.settings.curves)
    for (const CurveQuantity& curve : manifest.curves)
      columns +=
          static_cast<double>(curveTimes_s(*manifest.settings.curves).size() * (curve.per_law ? laws : 1));
  double bytes = 0;
  for (const std::size_t task : tasks)
    bytes += 2 * 8 * columns * static_cast<double>(plan.tasks()[task].laws.size());  // journal and table
  return bytes;
}

/// As if all were as large as the first that can be run at all.
double resultBytes(const SweepPlan& plan, const std::vector<std::size_t>& tasks) {
  constexpr std::size_t most_tried = 100;
  for (std::size_t i = 0; i < std::min(most_tried, tasks.size()); ++i) {
    try {
      LoadedScenario some = parseScenario(plan.manifest().scenario, plan.directory() / "base",
                                          plan.overridesAt(plan.tasks()[tasks[i]].point));
      const std::vector<RunPlan> plans =
          planRuns(checkLoaded("base", std::move(some), {plan.manifest().pipelines, {}, true, false}));
      double bytes = 0;
      for (const std::size_t task : tasks) bytes += plans[plan.tasks()[task].entry].bytes();
      return bytes;
    } catch (const InputError&) {  // a combination that cannot be run; its row will say so
    }
  }
  return 0;
}

}  // namespace

double SweepEstimate::total_s(std::size_t tasks, int slots) const {
  return one_s.value_or(0) * std::ceil(static_cast<double>(tasks) / std::max(1, slots));
}

SweepEstimate estimateSweep(const SweepPlan& plan, const SweepState& state,
                            const std::vector<std::size_t>& tasks, std::size_t timed_from,
                            Interrupt& interrupt) {
  SweepEstimate estimate;
  if (tasks.empty()) return estimate;
  estimate.bytes = bytesOf(plan, tasks);
  if (plan.keepsResults()) estimate.bytes += resultBytes(plan, tasks);
  std::vector<double> known_s;
  for (std::size_t i = 0; i < plan.tasks().size(); ++i)
    if (state.task(i).finished && state.task(i).wall_s > 0) known_s.push_back(state.task(i).wall_s);
  if (!known_s.empty())
    estimate.one_s = meanOf(known_s);
  else if (tasks.size() >= timed_from)
    estimate.one_s = timeSome(plan, tasks, interrupt);
  return estimate;
}

}  // namespace fissure
