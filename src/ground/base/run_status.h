#pragma once

#include <string>

namespace fissure {

/// How a run ended, or why it has no end. The worker itself reports `ok` and `non_finite`; the others are set
/// by the process that watches the worker.
enum class RunEnd {
  ok,           ///< it ran to its end
  non_finite,   ///< it stopped at a state that is not finite
  timeout,      ///< it was stopped at its time limit
  crashed,      ///< a signal ended its worker
  interrupted,  ///< it was stopped, or never started, because somebody asked for that
  failed,       ///< its worker ended with an error, or its part file cannot be read
  salvaged,     ///< the watching process was gone; the result holds the steps that had reached the disk
  incomplete,   ///< its worker has not finished the part file, and may be dead
  missing,      ///< in a sweep: nothing is recorded of this run
};

/// The end as files, tables and messages name it: the enumerator's own name.
std::string nameOf(RunEnd end);

/// The end with this name. Throws InputError, without a file, about a name that nameOf() never returns, as in
/// a damaged file or one of a newer program.
RunEnd runEndNamed(const std::string& name);

struct RunStatus {
  RunEnd end = RunEnd::ok;
  std::string detail;  ///< one line for people: when, where, by which signal
};

}  // namespace fissure
