#pragma once

#include <string>

namespace fissure {

/// The unit that the name of a summary value carries: "max_force_N" "N", "first_contact_time_s" "s"; "1"
/// where it carries none.
std::string summaryUnit(const std::string& name);

}  // namespace fissure
