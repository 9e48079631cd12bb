#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "batch/experiment.h"
#include "process/progress_display.h"
#include "process/worker_pool.h"

namespace fissure {

/// How a batch ended, the worst last.
enum class BatchOutcome {
  good,
  unexpected,  ///< all ran, but something that a scenario expects does not hold
  failed,      ///< a run, or writing a result
  interrupted,
};

/// Runs experiments through one pool of workers; each result is written as soon as its last run has ended.
class Batch : private PoolObserver {
 public:
  Batch(std::vector<Experiment>& experiments, const std::string& command_line, ProgressDisplay& display);

  /// Throws RunError when a result cannot be written; workers are stopped then, and results written before
  /// stay.
  void run(int slots, Interrupt& interrupt);
  /// How all experiments together ended; call it after run().
  BatchOutcome outcome() const;

 private:
  void started(std::size_t task) override;
  void progressed(std::size_t task, const Progress& progress) override;
  void finished(std::size_t task, const RunStatus& status) override;
  void woke() override { display_.update(progress_); }

  std::vector<Experiment>& experiments_;
  std::string command_line_;
  ProgressDisplay& display_;
  std::vector<WorkerTask> tasks_;
  std::vector<std::pair<std::size_t, std::size_t>> owners_;  ///< of a task: experiment, index of its run
  std::vector<RunProgress> progress_;                        ///< of a task
};

}  // namespace fissure
