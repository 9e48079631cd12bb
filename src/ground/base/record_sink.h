#pragma once

#include "base/image.h"
#include "base/record.h"
#include "base/run_status.h"
#include "base/state.h"

namespace fissure {

/// Receives the output of a run in order of time. A worker's implementation writes its part file; tests have
/// another.
class RecordSink {
 public:
  virtual ~RecordSink() = default;
  /// Receives state.law_inputs of the step whose row comes next; called only where the scenario asks for
  /// them.
  virtual void forceInputs(const State& state) = 0;
  /// Receives the row of one step.
  virtual void append(const RecordRow& row) = 0;
  /// Receives a state whose positions are kept.
  virtual void snapshot(const State& state) = 0;
  /// Receives the picture of the state at `time_s`.
  virtual void frame(double time_s, const Image& image) = 0;
  /// Receives the end of the run, once and last. Values named "timing/..." depend on the clock; those named
  /// "provenance/..." are texts about the programs and libraries that made the run.
  virtual void finish(const RunStatus& status, const Summary& summary) = 0;
};

}  // namespace fissure
