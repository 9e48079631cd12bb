#include "process/worker_pool.h"

#include <poll.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"

namespace fissure {

void WorkerPool::run(std::size_t tasks, const std::function<WorkerTask(std::size_t)>& make,
                     PoolObserver& observer) {
  next_ = 0;
  running_.clear();
  try {
    while (next_ < tasks || !running_.empty()) {
      if (interrupt_.requested() || observer.wantsStop()) return stopAll(tasks, observer);
      startMore(tasks, make, observer);
      if (!running_.empty()) wait();
      collect(observer);
      observer.woke();
    }
  } catch (...) {
    running_.clear();
    throw;
  }
}

void WorkerPool::startMore(std::size_t tasks, const std::function<WorkerTask(std::size_t)>& make,
                           PoolObserver& observer) {
  while (next_ < tasks && running_.size() < static_cast<std::size_t>(std::max(1, slots_))) {
    const std::size_t task = next_++;
    try {
      running_.push_back({task, std::make_unique<Worker>(make(task)), {}});
    } catch (const RunError& error) {
      observer.hindered(task, error.what());
      continue;
    }
    observer.started(task);
  }
}

/// Sleeps until a worker says something, a request comes, or the next look at the workers is due.
void WorkerPool::wait() const {
  constexpr double look_every_s = 0.1;
  // A worker that closed its pipes is about to end; of some systems one must ask when.
  constexpr double look_for_end_every_s = 0.005;
  std::vector<pollfd> watched = {{interrupt_.descriptor(), POLLIN, 0}};
  double timeout_s = look_every_s;
  for (const Running& running : running_) {
    const std::array<int, 2> pipes = running.worker->descriptors();
    bool wakes = false;
    for (const int descriptor : {pipes[0], pipes[1], running.worker->endDescriptor()}) {
      if (descriptor < 0) continue;
      watched.push_back({descriptor, POLLIN, 0});
      wakes = true;
    }
    timeout_s =
        std::min({timeout_s, running.worker->timeLeft_s(), wakes ? look_every_s : look_for_end_every_s});
  }
  ::poll(watched.data(), watched.size(), static_cast<int>(std::ceil(timeout_s * 1e3)));
}

void WorkerPool::collect(PoolObserver& observer) {
  for (std::size_t i = 0; i < running_.size();) {
    running_[i].worker->read();
    const auto status = running_[i].worker->poll();
    const std::size_t task = running_[i].task;
    const Progress progress = running_[i].worker->progress();
    if (progress != running_[i].seen) observer.progressed(task, progress);
    running_[i].seen = progress;
    if (!status) {
      ++i;
      continue;
    }
    const bool unwritten = running_[i].worker->unwritten();
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
    if (unwritten)
      observer.hindered(task, status->detail);
    else
      observer.finished(task, *status);
  }
}

void WorkerPool::stopAll(std::size_t tasks, PoolObserver& observer) {
  collect(observer);  // what has just finished is finished
  std::vector<Running> stopped;
  stopped.swap(running_);
  std::vector<RunStatus> statuses;
  statuses.reserve(stopped.size());
  for (const Running& running : stopped)
    statuses.push_back(running.worker->stop(RunEnd::interrupted, "stopped"));
  for (std::size_t i = 0; i < stopped.size(); ++i) observer.finished(stopped[i].task, statuses[i]);
  for (; next_ < tasks; ++next_) observer.finished(next_, {RunEnd::interrupted, "not started"});
}

}  // namespace fissure
