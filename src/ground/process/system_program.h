#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fissure {

/// What a program of the system said, and how it ended.
struct ProgramOutcome {
  bool in_time = true;  ///< else it was killed, and the rest is what it said before
  int code = 0;         ///< its exit code
  std::string output;   ///< stdout
  std::string error;    ///< the last line that is not blank of stderr, printable
};

/// Runs a program to its end, for `most_s` seconds at most, without a shell and with nothing to read. Throws
/// RunError when it cannot start or a signal of somebody else ends it. Call from the process's main thread,
/// as for Worker.
ProgramOutcome runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          double most_s);

}  // namespace fissure
