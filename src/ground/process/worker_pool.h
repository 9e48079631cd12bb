#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/run_status.h"
#include "process/interrupt.h"
#include "process/worker.h"

namespace fissure {

/// Hears what happens in a pool, in the thread that runs it. `task` counts from 0 in the order of the tasks
/// given.
class PoolObserver {
 public:
  virtual ~PoolObserver() = default;
  virtual void started(std::size_t task) = 0;
  virtual void progressed(std::size_t task, const Progress& progress) = 0;
  /// Called exactly once for every task, also for one that never started (then `failed` or `interrupted`).
  virtual void finished(std::size_t task, const RunStatus& status) = 0;
  /// Called whenever the pool woke up, at least about ten times a second: to refresh a display.
  virtual void woke() = 0;
  /// Whether all that runs should be stopped and no more be started; asked after woke().
  virtual bool wantsStop() const { return false; }
};

/// Runs tasks in processes of their own, a fixed number of them side by side, and watches them.
class WorkerPool {
 public:
  /// `slots`: workers side by side, at least 1. A request to `interrupt` stops the running workers and starts
  /// no other.
  WorkerPool(int slots, Interrupt& interrupt) : slots_(slots), interrupt_(interrupt) {}

  /// Runs all tasks, in order of their start, and returns when the last has ended. The observer hears every
  /// end at once; what it throws stops all workers and is passed on.
  void run(const std::vector<WorkerTask>& tasks, PoolObserver& observer) {
    run(
        tasks.size(), [&](std::size_t task) { return tasks[task]; }, observer);
  }
  /// The same of tasks that are made when their turn comes; a RunError then is that task's end (`failed`).
  void run(std::size_t tasks, const std::function<WorkerTask(std::size_t task)>& make,
           PoolObserver& observer);

 private:
  struct Running {
    std::size_t task = 0;
    std::unique_ptr<Worker> worker;
    Progress seen;
  };

  void startMore(std::size_t tasks, const std::function<WorkerTask(std::size_t)>& make,
                 PoolObserver& observer);
  void wait() const;
  void collect(PoolObserver& observer);
  void stopAll(std::size_t tasks, PoolObserver& observer);

  int slots_;
  Interrupt& interrupt_;
  std::size_t next_ = 0;  ///< first task not started
  std::vector<Running> running_;
};

}  // namespace fissure
