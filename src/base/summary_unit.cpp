#include "base/summary_unit.h"

#include <array>
#include <string_view>
#include <utility>

namespace fissure {

std::string summaryUnit(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> endings = {
      {{"_m_s", "m s-1"}, {"_m", "m"}, {"_N", "N"}, {"_s", "s"}, {"_us", "us"}, {"_hz", "Hz"}, {"_J", "J"}}};
  for (const auto& [ending, unit] : endings)
    if (name.size() > ending.size() && name.ends_with(ending)) return std::string(unit);
  return "1";
}

}  // namespace fissure
