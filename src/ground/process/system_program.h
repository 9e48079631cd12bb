#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace fissure {

/// A program was ended by a crash or by a signal that is not ours.
class KilledProgram : public RunError {
 public:
  KilledProgram(const std::string& name, int signal)
      : RunError(name + ": killed by signal " + std::to_string(signal)), signal_(signal) {}
  int signal() const { return signal_; }

 private:
  int signal_;
};

/// The output of a program and how it ended.
struct ProgramOutcome {
  /// False: it was killed at its time limit, and output and error are those up to then.
  bool in_time = true;
  int code = 0;        ///< its exit code
  std::string output;  ///< stdout
  std::string error;   ///< last non-blank line of stderr, made printable
};

/// Runs a program to its end, for `most_s` seconds at most, without a shell and with empty standard input; it
/// dies with this process. Throws RunError when it cannot start, KilledProgram when a signal ends it, and
/// Interrupted when `stop_descriptor` becomes readable (-1: never), after the program has been ended. Call
/// from the process's main thread, as for Worker.
ProgramOutcome runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          double most_s, int stop_descriptor = -1);

}  // namespace fissure
