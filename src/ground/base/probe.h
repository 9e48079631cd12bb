#pragma once

#include <memory>
#include <vector>

#include "base/record.h"
#include "base/state.h"

namespace fissure {

/// A measurement that is taken in every step: it declares its time series once, then fills their columns. A
/// run has the probes that its scenario needs and no others.
class Probe {
 public:
  virtual ~Probe() = default;
  /// Adds this probe's axes and series; called once, before the first sample.
  virtual void declare(RecordLayout& layout) = 0;
  /// Fills this probe's columns of `row` (which has layout.columns() entries) from the state of one step.
  virtual void sample(const State& state, RecordRow& row) = 0;
  /// Appends this probe's scalars after the last step; without any sample they are NaN, never zero.
  virtual void summarize(Summary& summary) const = 0;
};

/// Declares the columns of a run's record: `time`, then the series of the probes in their order. Throws
/// std::logic_error when two probes declare the same series.
RecordLayout declareLayout(const std::vector<std::unique_ptr<Probe>>& probes);

}  // namespace fissure
