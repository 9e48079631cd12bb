#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "process/progress.h"

namespace fissure {

/// One run as a progress line shows it.
struct RunProgress {
  enum class Phase { waiting, running, ended };
  std::string name;
  Phase phase = Phase::waiting;
  Progress progress;  ///< `steps` is known from the start
};

/// "12 s", "3 min", "2 h 5 min".
std::string durationText(double seconds);

/// One line about `runs` after `elapsed_s`: percent of each running one, runs done, steps a second, time
/// left.
std::string progressLine(const std::vector<RunProgress>& runs, double elapsed_s);

/// Shows how far a batch is: on a terminal one line that is rewritten and cleared at the end, elsewhere a
/// plain line at most every five seconds.
class ProgressDisplay {
 public:
  /// `descriptor`: of the terminal or file behind `stream`; a terminal is asked for its width and told to
  /// empty its line.
  ProgressDisplay(std::ostream& stream, int descriptor);
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Call as often as you like.
  void update(const std::vector<RunProgress>& runs);
  /// The same for other work: `line` says how far it is after so many seconds.
  void show(const std::function<std::string(double elapsed_s)>& line);
  /// Takes the line off the terminal, before something else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void emptyLine();

  std::ostream& stream_;
  int descriptor_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace fissure
