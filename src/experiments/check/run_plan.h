#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/record.h"
#include "check/scenario_input.h"

namespace fissure {

/// What one run will do and keep, known without running it.
struct RunPlan {
  const PipelineSettings* pipeline = nullptr;  ///< in the scenario
  std::int64_t settling_steps = 0;
  std::int64_t steps = 0;
  int nodes = 0;                    ///< on all tools; 0: the pipeline uses none
  std::vector<std::string> series;  ///< datasets over time, in the order of the record
  std::int64_t snapshots = 0;
  std::int64_t frames = 0;
  double record_bytes = 0;
  double snapshot_bytes = 0;
  int force_input_bytes = 0;  ///< of one triangle in one step; how many collide only the run knows
  double frame_bytes = 0;     ///< before compression, an upper bound

  double bytes() const { return record_bytes + snapshot_bytes + frame_bytes; }
};

/// The series of the record of a run through `pipeline`, one of the scenario's.
RecordLayout layoutOf(const CheckedScenario& checked, const PipelineSettings& pipeline);

/// One plan a pipeline entry. `checked` must outlive them.
std::vector<RunPlan> planRuns(const CheckedScenario& checked);

}  // namespace fissure
