#include "batch/pilot_runs.h"

#include <fmt/core.h>

#include <chrono>

#include "base/error.h"
#include "batch/engine_program.h"
#include "files/input_file.h"
#include "files/temporary_folder.h"
#include "files/write_file.h"
#include "process/worker_pool.h"
#include "text/units.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// Takes the time of each task of a pool with one slot.
class PilotWatch : public PoolObserver {
 public:
  explicit PilotWatch(std::vector<PilotRun>& runs) : runs_(runs) {}

  void started(std::size_t) override { start_ = Clock::now(); }
  void progressed(std::size_t task, const Progress& progress) override { runs_[task].progress = progress; }
  void finished(std::size_t task, const RunStatus& status) override {
    runs_[task].status = status;
    runs_[task].wall_s = std::chrono::duration<double>(Clock::now() - start_).count();
  }
  void woke() override {}

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<PilotRun>& runs_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

std::string forecastLine(const PilotRun& pilot, double limit_s) {
  if (!pilot.forecast)
    return fmt::format("unknown, the pilot {}: {}", nameOf(pilot.status.end), pilot.status.detail);
  constexpr double same = 1.2;
  const Forecast& forecast = *pilot.forecast;
  const std::string time = forecast.high_s < same * forecast.low_s
                               ? "about " + timeText(forecast.run_s)
                               : fmt::format("{} to {}", timeText(forecast.low_s), timeText(forecast.high_s));
  const std::string beyond =
      forecast.high_s > limit_s ? ", which may be beyond its limit of " + timeText(limit_s) : "";
  return fmt::format("{} (pilot of {} of {} steps took {}){}", time, forecast.pilot_steps, forecast.run_steps,
                     timeText(pilot.wall_s), beyond);
}

std::vector<PilotRun> runPilots(std::vector<WorkerTask> tasks, int one_in, const fs::path& folder,
                                Interrupt& interrupt) {
  const auto file = [&](std::size_t task) { return folder / (std::to_string(task) + ".forecast"); };
  for (std::size_t t = 0; t < tasks.size(); ++t)
    for (const std::string& word :
         {std::string("--pilot"), std::to_string(one_in), std::string("--forecast"), file(t).string()})
      tasks[t].arguments.push_back(word);
  std::vector<PilotRun> runs(tasks.size());
  PilotWatch watch(runs);
  WorkerPool(1, interrupt).run(tasks, watch);
  for (std::size_t t = 0; t < runs.size(); ++t)
    if (runs[t].status.end == RunEnd::ok)
      runs[t].forecast = parseForecast(readInputFile(file(t), "a forecast"));
  return runs;
}

std::vector<PilotRun> runPilots(const CheckedScenario& checked, int one_in, Interrupt& interrupt) {
  const TemporaryFolder folder;
  const fs::path scenario = folder.path() / "resolved.yaml";
  writeFile(scenario, checked.loaded.resolved);
  std::vector<WorkerTask> tasks;
  for (const PipelineSettings& pipeline : checked.loaded.scenario.pipelines)
    tasks.push_back(engineTask({scenario, fs::absolute(checked.loaded.scenario.directory), pipeline,
                                folder.path() / (std::to_string(tasks.size()) + ".part")}));
  std::vector<PilotRun> runs = runPilots(std::move(tasks), one_in, folder.path(), interrupt);
  if (interrupt.requested()) throw Interrupted();
  return runs;
}

}  // namespace fissure
