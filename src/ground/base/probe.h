#pragma once

#include <memory>
#include <vector>

#include "base/record.h"
#include "base/state.h"

namespace fissure {

/// One thing that is looked at in every step: declares its series once, then fills their columns.
/// A run is composed of the probes its scenario needs, and pays for no other.
class Probe {
 public:
  virtual ~Probe() = default;
  /// Adds this probe's axes and series; called once, before the first sample.
  virtual void declare(RecordLayout& layout) = 0;
  /// Fills this probe's columns of `row` (which has layout.columns() entries) from the state of one step.
  virtual void sample(const State& state, RecordRow& row) = 0;
  /// Appends this probe's scalars after the last step; with no sample before, values are NaN, never zero.
  virtual void summarize(Summary& summary) const = 0;
};

/// The columns of a run's record: `time`, then the probes' series.
RecordLayout declareLayout(const std::vector<std::unique_ptr<Probe>>& probes);

}  // namespace fissure
