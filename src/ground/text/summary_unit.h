#pragma once

#include <string>

namespace fissure {

/// The unit that the name of a summary value or of a scenario's key carries, in UDUNITS form where that knows
/// it: "max_force_N" "N", "stiffness_N_m" "N m-1", "field_of_view_deg" "degree"; also of one number of a
/// list, "start_m_1" "m". "1" where it carries none.
std::string summaryUnit(const std::string& name);

/// The name without its unit: "max_force", "stiffness", "start_1".
std::string withoutUnit(const std::string& name);

}  // namespace fissure
