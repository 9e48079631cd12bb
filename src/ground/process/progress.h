#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fissure {

/// Progress of a worker in steps of the run, without the steps of settling.
struct Progress {
  std::int64_t step = 0;   ///< finished steps, 0..steps
  std::int64_t steps = 0;  ///< steps of the whole run; 0: not known yet

  bool operator==(const Progress&) const = default;
};

/// Parses a worker's line `progress <step> <steps>`; no value for any other line and for impossible numbers.
std::optional<Progress> parseProgress(std::string_view line);

/// "after step 12 of 500", or "before its first step", for the detail of a RunStatus.
std::string describe(const Progress& progress);

}  // namespace fissure
