#include "text/summary_unit.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace fissure {

namespace {

struct UnitEnding {
  std::string_view ending;
  std::string_view unit;
};

// An ending before those that it ends with.
constexpr std::array<UnitEnding, 18> endings = {{{"_N_s_m", "N s m-1"},
                                                 {"_Pa_s", "Pa s"},
                                                 {"_1_s", "s-1"},
                                                 {"_N_m", "N m-1"},
                                                 {"_kg_m3", "kg m-3"},
                                                 {"_m_s2", "m s-2"},
                                                 {"_m_s", "m s-1"},
                                                 {"_m", "m"},
                                                 {"_N", "N"},
                                                 {"_s", "s"},
                                                 {"_us", "us"},
                                                 {"_hz", "Hz"},
                                                 {"_J", "J"},
                                                 {"_Pa", "Pa"},
                                                 {"_kg", "kg"},
                                                 {"_deg", "degree"},
                                                 {"_px", "pixel"},
                                                 {"_mb", "MiB"}}};

/// Where the numbers begin that say which item of a list it is: the "_1" of "start_m_1".
std::size_t endOfKey(std::string_view name) {
  std::size_t end = name.size();
  for (std::size_t at = end; at > 0;) {
    while (at > 0 && name[at - 1] >= '0' && name[at - 1] <= '9') --at;
    if (at == end || at == 0 || name[at - 1] != '_') break;
    end = --at;
  }
  return end;
}

const UnitEnding* endingOf(std::string_view key) {
  const auto found = std::find_if(endings.begin(), endings.end(), [&](const UnitEnding& one) {
    return key.size() > one.ending.size() && key.ends_with(one.ending);
  });
  return found == endings.end() ? nullptr : found;
}

}  // namespace

std::string summaryUnit(const std::string& name) {
  const UnitEnding* const found = endingOf(std::string_view(name).substr(0, endOfKey(name)));
  return std::string(found ? found->unit : "1");
}

std::string withoutUnit(const std::string& name) {
  const std::size_t end = endOfKey(name);
  const UnitEnding* const found = endingOf(std::string_view(name).substr(0, end));
  return found ? name.substr(0, end - found->ending.size()) + name.substr(end) : name;
}

}  // namespace fissure
