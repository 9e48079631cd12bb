#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/run_status.h"
#include "process/interrupt.h"
#include "process/worker.h"

namespace fissure {

/// Is told of the events in a pool, in the thread that runs it. `task` is the index of a task, from 0 in the
/// order given to run().
class PoolObserver {
 public:
  virtual ~PoolObserver() = default;
  virtual void started(std::size_t task) = 0;
  virtual void progressed(std::size_t task, const Progress& progress) = 0;
  /// Called exactly once for every task, even for one that never started (then with `failed` or
  /// `interrupted`), unless hindered() is called.
  virtual void finished(std::size_t task, const RunStatus& status) = 0;
  /// Called where the machine is to blame for a task's end, which says nothing about the task: its worker
  /// could not be started, or could not write.
  virtual void hindered(std::size_t task, const std::string& reason) {
    finished(task, {RunEnd::failed, reason});
  }
  /// Called whenever the pool wakes up, at least about ten times a second, to refresh a display.
  virtual void woke() = 0;
  /// Whether the pool should stop all running tasks and start no more; asked after woke().
  virtual bool wantsStop() const { return false; }
};

/// Runs tasks in processes of their own, at most a fixed number of them at the same time, and watches them.
class WorkerPool {
 public:
  /// `slots`: number of workers at the same time, at least 1. A request to `interrupt` stops the running
  /// workers, and no others are started.
  WorkerPool(int slots, Interrupt& interrupt) : slots_(slots), interrupt_(interrupt) {}

  /// Runs all tasks, started in their order, and returns when the last has ended. The observer is told of
  /// every end at once; what the observer throws stops all workers and is rethrown.
  void run(const std::vector<WorkerTask>& tasks, PoolObserver& observer) {
    run(
        tasks.size(), [&](std::size_t task) { return tasks[task]; }, observer);
  }
  /// The same for tasks that `make` creates when their turn comes; where it throws RunError, that task is
  /// hindered.
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
