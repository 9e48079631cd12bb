#include "base/run_status.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace fissure {

namespace {

// In the order of RunEnd.
constexpr std::array<const char*, 9> end_names = {
    "ok", "non_finite", "timeout", "crashed", "interrupted", "failed", "salvaged", "incomplete", "missing"};
static_assert(end_names.size() == static_cast<std::size_t>(RunEnd::missing) + 1);

}  // namespace

std::string nameOf(RunEnd end) {
  return end_names.at(static_cast<std::size_t>(end));
}

RunEnd runEndNamed(const std::string& name) {
  const auto at = std::find(end_names.begin(), end_names.end(), name);
  if (at != end_names.end()) return static_cast<RunEnd>(at - end_names.begin());
  std::string known;
  for (const char* end : end_names) known += (known.empty() ? "" : ", ") + std::string(end);
  throw InputError("the status \"" + name + "\" of a run is unknown, expected one of " + known +
                   ": damaged, or written by a newer fissure");
}

}  // namespace fissure
