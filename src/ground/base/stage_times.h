#pragma once

#include <chrono>
#include <string>

namespace fissure {

/// Wall time that one stage of a simulation's steps has taken so far.
struct StageTime {
  std::string name;
  double total_s = 0;
};

/// A stopwatch that adds the time since its last lap to a stage.
class StageClock {
 public:
  /// Adds the seconds since the last lap, or since construction, to `stage_s`.
  void lap(double& stage_s) {
    const auto now = std::chrono::steady_clock::now();
    stage_s += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace fissure
