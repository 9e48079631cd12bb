#pragma once

#include "base/image.h"
#include "base/record.h"
#include "base/state.h"

namespace fissure {

/// How a run ended. `ok` and `non_finite` are said by the worker, the others by the front that watched it,
/// and `salvaged` where nobody was left to say it.
struct RunStatus {
  std::string status = "ok";  ///< ok | non_finite | timeout | crashed | interrupted | failed | salvaged
  std::string detail;         ///< one line: when, where, which signal
};

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
