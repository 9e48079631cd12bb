#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "batch/experiment.h"
#include "process/progress_display.h"
#include "process/worker_pool.h"

namespace fissure {

/// The outcome of a batch, from best to worst.
enum class BatchOutcome {
  good,
  unexpected,  ///< all runs ended well, but an expectation of a scenario does not hold
  failed,      ///< a run failed, or a result could not be written
  interrupted,
};

/// Runs experiments with one pool of workers. Each result is written as soon as its last run has ended.
class Batch : private PoolObserver {
 public:
  Batch(std::vector<Experiment>& experiments, const std::string& command_line, ProgressDisplay& display);

  /// Runs all experiments, with `slots` workers at the same time. Throws RunError when a result cannot be
  /// written; all workers are then stopped, and results written before stay.
  void run(int slots, Interrupt& interrupt);
  /// The worst outcome of all experiments; to be called after run().
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
  std::vector<std::pair<std::size_t, std::size_t>> owners_;  ///< [task] experiment, index of its run
  std::vector<RunProgress> progress_;                        ///< [task]
};

}  // namespace fissure
