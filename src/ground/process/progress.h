#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fissure {

/// How far a worker is. Settling is not counted.
struct Progress {
  std::int64_t step = 0;   ///< finished, 0..steps
  std::int64_t steps = 0;  ///< of the whole run; 0: not known yet

  bool operator==(const Progress&) const = default;
};

/// Reads a worker's line `progress <step> <steps>`; anything else, and numbers that make no sense, is no
/// value.
std::optional<Progress> parseProgress(std::string_view line);

/// "after step 12 of 500", or "before its first step", for the detail of a RunStatus.
std::string describe(const Progress& progress);

}  // namespace fissure
