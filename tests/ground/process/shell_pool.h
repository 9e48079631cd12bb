#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "process/worker_pool.h"

namespace fissure {

/// A worker that is a shell script, with `argument` as its $1.
inline WorkerTask shellTask(const std::string& script, double time_limit_s = 20,
                            const std::string& argument = "") {
  return {"/bin/sh", {"-c", script, "sh", argument}, time_limit_s};
}

/// Remembers what a pool said.
class Listener : public PoolObserver {
 public:
  void started(std::size_t task) override {
    starts.push_back(task);
    side_by_side = std::max(side_by_side, ++running);
  }
  void progressed(std::size_t task, const Progress& progress) override {
    last[task] = progress;
    ++calls;
  }
  void finished(std::size_t task, const RunStatus& status) override {
    if (!starts.empty() && status.detail != "not started") --running;
    EXPECT_TRUE(ends.emplace(task, status).second) << "heard the end of task " << task << " twice";
  }
  void woke() override {}

  std::vector<std::size_t> starts;
  std::map<std::size_t, RunStatus> ends;
  std::map<std::size_t, Progress> last;
  int calls = 0;
  int running = 0;
  int side_by_side = 0;
};

inline Listener runPool(const std::vector<WorkerTask>& tasks, int slots = 1) {
  Interrupt interrupt;
  Listener listener;
  WorkerPool(slots, interrupt).run(tasks, listener);
  EXPECT_EQ(listener.ends.size(), tasks.size());
  return listener;
}

/// Status and detail of one worker, as "status|detail".
inline std::string endOf(const WorkerTask& task) {
  const RunStatus status = runPool({task}).ends[0];
  return nameOf(status.end) + "|" + status.detail;
}

}  // namespace fissure
