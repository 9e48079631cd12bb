#pragma once

#include "base/image.h"
#include "base/record.h"
#include "base/run_status.h"
#include "base/state.h"

namespace fissure {

/// Takes what a run produces, in order of time. The part file of a worker is one; tests use another.
class RecordSink {
 public:
  virtual ~RecordSink() = default;
  /// What the force laws saw in the step whose row comes next; only for a scenario that asks for it.
  virtual void forceInputs(const State& state) = 0;
  virtual void append(const RecordRow& row) = 0;
  virtual void snapshot(const State& state) = 0;
  virtual void frame(double time_s, const Image& image) = 0;
  /// Values named "timing/..." depend on the clock; those named "provenance/..." are texts that say what made
  /// the run.
  virtual void finish(const RunStatus& status, const Summary& summary) = 0;
};

}  // namespace fissure
