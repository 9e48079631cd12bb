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
#include "sweep/file_stamp.h"
#include "sweep/journal.h"
#include "sweep/sweep_plan.h"
#include "task/task_order.h"
#include "task/task_record.h"

namespace fissure {

/// The order for the worker of a task.
TaskOrder orderOf(const SweepPlan& plan, const SweepTask& task);

/// Counts of the tasks in a session of a sweep.
struct SessionCounts {
  std::size_t ok = 0;
  std::size_t failed = 0;       ///< any status but ok
  std::size_t interrupted = 0;  ///< stopped or not started
  /// Tried for the first time, or finished; while there are such tasks, another session makes sense.
  std::size_t advanced = 0;
};

/// Simulates tasks of a sweep and records each as soon as it has ended, in a journal of its own. Other
/// sessions may run the same tasks at the same time: their records are equal.
class SweepSession : private PoolObserver {
 public:
  struct Settings {
    int slots = 1;
    std::size_t untried = 0;  ///< number of tasks, the first ones, without any record yet
    bool fail_fast = false;   ///< stop after the first failure
    std::string command_line;
  };
  /// `tasks`: indices of tasks of the plan, to be run in this order. All references must outlive the session.
  SweepSession(const SweepPlan& plan, const std::filesystem::path& folder, std::vector<std::size_t> tasks,
               Settings settings, ProgressDisplay& display);
  SweepSession(const SweepSession&) = delete;
  SweepSession& operator=(const SweepSession&) = delete;

  /// Runs the tasks. Throws RunError when records or workers' files cannot be written (a full disk), a worker
  /// cannot be started, or an input file of the scenario changes meanwhile; earlier records stay.
  void run(Interrupt& interrupt);

  const SessionCounts& counts() const { return counts_; }
  /// A text with the first task that failed and its reason; empty while none has.
  const std::string& firstFailure() const { return first_failure_; }

 private:
  void started(std::size_t task) override;
  void progressed(std::size_t task, const Progress& progress) override;
  void finished(std::size_t task, const RunStatus& status) override;
  void hindered(std::size_t task, const std::string& reason) override;
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
  /// Path, and its size and time as text.
  std::vector<std::pair<std::filesystem::path, FileStamp>> inputs_;
  struct Running {
    Clock::time_point start;
    Progress progress;
  };
  std::map<std::size_t, Running> running_;
  SessionCounts counts_;
  std::string first_failure_;
};

}  // namespace fissure
