#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/record.h"
#include "check/scenario_input.h"

namespace fissure {

/// The steps and the output of one run, known without running it.
struct RunPlan {
  const PipelineSettings* pipeline = nullptr;  ///< its entry in the scenario
  std::int64_t settling_steps = 0;
  std::int64_t steps = 0;
  int nodes = 0;                    ///< number of nodes on all tools; 0: the pipeline uses none
  std::vector<std::string> series;  ///< names of the datasets over time, in the order of the record
  std::int64_t snapshots = 0;
  std::int64_t frames = 0;
  double record_bytes = 0;
  double snapshot_bytes = 0;
  /// Bytes per colliding triangle and step; their number is known only from the run.
  int force_input_bytes = 0;
  double frame_bytes = 0;  ///< upper bound: size before compression

  double bytes() const { return record_bytes + snapshot_bytes + frame_bytes; }
};

/// The layout of the record of a run with `pipeline`, an entry of the scenario.
RecordLayout layoutOf(const CheckedScenario& checked, const PipelineSettings& pipeline);

/// The summary of such a run without a single step: it has the names of all values, but no values.
Summary emptySummaryOf(const CheckedScenario& checked, const PipelineSettings& pipeline);

/// One plan per pipeline entry. `checked` must outlive them.
std::vector<RunPlan> planRuns(const CheckedScenario& checked);

}  // namespace fissure
