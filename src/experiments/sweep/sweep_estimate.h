#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "process/interrupt.h"
#include "sweep/sweep_state.h"

namespace fissure {

/// The estimated cost of a sweep.
struct SweepEstimate {
  std::optional<double> one_s;  ///< wall time of a simulation; no value where none could be timed
  double bytes = 0;             ///< size of the tasks' output on disk

  /// Wall time of that many tasks with `slots` workers at the same time.
  double total_s(std::size_t tasks, int slots) const;
};

/// Estimates the cost of `tasks`: wall time from recorded simulations, else from pilots of three of the tasks
/// (see runPilots), of at most 20 seconds each, unless there are fewer than `timed_from` tasks; disk space
/// from the size of the kept output. Throws Interrupted on a request to stop while pilots run.
SweepEstimate estimateSweep(const SweepPlan& plan, const SweepState& state,
                            const std::vector<std::size_t>& tasks, std::size_t timed_from,
                            Interrupt& interrupt);

}  // namespace fissure
