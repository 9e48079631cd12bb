#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "process/progress.h"

namespace fissure {

/// The state of one run, as a progress line shows it.
struct RunProgress {
  enum class Phase { waiting, running, ended };
  std::string name;
  Phase phase = Phase::waiting;
  Progress progress;  ///< `steps` is known from the start
};

/// A duration for people: "12 s", "3 min", "2 h 5 min".
std::string durationText(double seconds);

/// A line about the progress of `runs` after `elapsed_s` seconds: runs done, per cent of each running one,
/// steps per second and the time that is left.
std::string progressLine(const std::vector<RunProgress>& runs, double elapsed_s);

/// Number of columns of the terminal behind a descriptor, 80 where it does not tell; no value for a file or a
/// pipe.
std::optional<std::size_t> terminalColumns(int descriptor);

/// Shows the progress of a batch on a terminal, by one line that is rewritten and cleared at the end; writes
/// nothing to files and pipes.
class ProgressDisplay {
 public:
  /// `descriptor`: the descriptor behind `stream`, by which a terminal is asked for its width and its line is
  /// cleared.
  ProgressDisplay(std::ostream& stream, int descriptor);
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Shows progressLine() of `runs`, at most ten times a second; may be called as often as convenient.
  void update(const std::vector<RunProgress>& runs);
  /// The same for other work: `line` returns the text for the elapsed time.
  void show(const std::function<std::string(double elapsed_s)>& line);
  /// Removes the line from the terminal; call it before something else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void emptyLine();

  std::ostream& stream_;
  int descriptor_;
  std::optional<std::size_t> columns_;  ///< width of the terminal; no value: no terminal
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace fissure
