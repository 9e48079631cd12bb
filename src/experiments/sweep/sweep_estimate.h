#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "process/interrupt.h"
#include "sweep/sweep_state.h"

namespace fissure {

/// What a sweep will take.
struct SweepEstimate {
  std::optional<double> one_s;  ///< wall time of a simulation; nothing where none could be timed
  double bytes = 0;             ///< on disk, of these tasks

  /// Wall time of that many tasks when `slots` workers run them side by side.
  double total_s(std::size_t tasks, int slots) const;
};

/// Wall time from the simulations that are recorded already, else from three of `tasks` that are run for at
/// most two seconds each and dropped; not for fewer than `timed_from` tasks. Disk from the size of what is
/// kept.
SweepEstimate estimateSweep(const SweepPlan& plan, const SweepState& state,
                            const std::vector<std::size_t>& tasks, std::size_t timed_from,
                            Interrupt& interrupt);

}  // namespace fissure
