#pragma once

#include <string>

namespace fissure {

/// How a run ended, or why it has no end. The worker says `ok` and `non_finite`, the front that watched it
/// says the others.
enum class RunEnd {
  ok,           ///< it came to its end
  non_finite,   ///< it came to a state that is no number, and stopped there
  timeout,      ///< it was stopped at its time limit
  crashed,      ///< a signal ended its worker
  interrupted,  ///< it was stopped, or never started, because somebody asked for that
  failed,       ///< its worker gave up, or what it left cannot be read
  salvaged,     ///< nobody was left to say how it ended; its result holds what had reached the disk
  incomplete,   ///< its worker has not finished the part file, and may be dead
  missing,      ///< of a sweep: nothing is recorded of it
};

/// The end as files, tables and messages name it: the enumerator's own name.
std::string nameOf(RunEnd end);

/// The end of that name. Throws InputError, without a file, about a name that nameOf() does not give: of a
/// damaged file, or of a newer program.
RunEnd runEndNamed(const std::string& name);

struct RunStatus {
  RunEnd end = RunEnd::ok;
  std::string detail;  ///< one line: when, where, which signal
};

}  // namespace fissure
