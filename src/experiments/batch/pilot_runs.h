#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/run_status.h"
#include "check/scenario_input.h"
#include "pilot/forecast.h"
#include "process/interrupt.h"
#include "process/progress_display.h"
#include "process/worker.h"

namespace fissure {

/// The outcome of a pilot, with its forecast for the run.
struct PilotRun {
  RunStatus status;
  Progress progress;                 ///< steps that it made
  double wall_s = 0;                 ///< wall time of the pilot, from the start of its worker to its end
  std::optional<Forecast> forecast;  ///< only if the status is ok
};

/// The forecast for people: "about 2 min 10 s (pilot of 56 of 560 steps took 13 s)", with a range where its
/// ends differ by more than a fifth; or the reason why there is none. A time beyond `limit_s` is marked.
std::string forecastLine(const PilotRun& pilot, double limit_s);

/// Runs the pilots of tasks for engine workers, one after the other, with about one in `one_in` of the steps.
/// The caller must remove their output and the files in `folder`. After a request to stop the remaining
/// pilots have no forecast.
std::vector<PilotRun> runPilots(std::vector<WorkerTask> tasks, int one_in,
                                const std::filesystem::path& folder, Interrupt& interrupt);

/// Runs the pilots of a scenario's runs, in the order of its pipeline entries; their output is removed.
/// Throws Interrupted on a request to stop.
std::vector<PilotRun> runPilots(const CheckedScenario& checked, int one_in, Interrupt& interrupt);

}  // namespace fissure
