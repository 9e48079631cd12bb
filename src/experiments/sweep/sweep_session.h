#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "process/progress_display.h"
#include "process/worker_pool.h"
#include "sweep/journal.h"
#include "sweep/sweep_plan.h"
#include "task/task_order.h"
#include "task/task_record.h"

namespace fissure {

/// What of a simulation's order stands in its task.
TaskOrder orderOf(const SweepPlan& plan, const SweepTask& task);

/// Whether a result file is as it was when its record was written, by size and time alone.
bool isUntouched(const std::filesystem::path& file, long long bytes, long long time);

/// How a session of a sweep went.
struct SessionCounts {
  std::size_t ok = 0;
  std::size_t failed = 0;       ///< anything but status ok
  std::size_t interrupted = 0;  ///< stopped or not started
  std::size_t advanced = 0;  ///< tried for the first time or finished: as long as there are such it goes on
};

/// Simulates tasks of a sweep and records each as soon as it has ended, in a journal of its own. It may run
/// while others run the same tasks: their records are equal.
class SweepSession : private PoolObserver {
 public:
  struct Settings {
    int slots = 1;
    std::size_t untried = 0;  ///< so many of the tasks, the first ones, have no record yet
    bool fail_fast = false;   ///< stop at the first that failed
    std::string command_line;
  };
  /// `tasks`: of the plan, to be run in this order. What the arguments refer to must outlive the session.
  SweepSession(const SweepPlan& plan, const std::filesystem::path& folder, std::vector<std::size_t> tasks,
               Settings settings, ProgressDisplay& display);
  SweepSession(const SweepSession&) = delete;
  SweepSession& operator=(const SweepSession&) = delete;

  /// Throws RunError when nothing can be recorded any more (a full disk), or an input file of the scenario
  /// changes meanwhile; what was recorded stays.
  void run(Interrupt& interrupt);

  const SessionCounts& counts() const { return counts_; }
  /// The task that failed first, and why; empty while none has.
  const std::string& firstFailure() const { return first_failure_; }

 private:
  void started(std::size_t task) override;
  void progressed(std::size_t task, const Progress& progress) override;
  void finished(std::size_t task, const RunStatus& status) override;
  void woke() override;
  bool wantsStop() const override { return settings_.fail_fast && counts_.failed > 0; }

  using Clock = std::chrono::steady_clock;

  WorkerTask workerTask(std::size_t task) const;
  std::filesystem::path work(std::size_t task, const char* ending) const;
  TaskRecord recordOf(std::size_t task, const RunStatus& status) const;
  void keepResult(std::size_t task, TaskRecord& record) const;
  void refuseChangedInputs() const;
  std::string progressLine(double elapsed_s) const;

  const SweepPlan& plan_;
  std::filesystem::path folder_;
  std::vector<std::size_t> tasks_;
  Settings settings_;
  ProgressDisplay& display_;
  JournalWriter journal_;
  std::vector<std::pair<std::filesystem::path, std::string>> inputs_;  ///< size and time of each
  struct Running {
    Clock::time_point start;
    Progress progress;
  };
  std::map<std::size_t, Running> running_;
  SessionCounts counts_;
  std::string first_failure_;
};

}  // namespace fissure
