#pragma once

#include <string>

namespace fissure {

/// The unit that stands at the end of the name of a summary value or scenario key, in UDUNITS form where
/// UDUNITS knows it: "N" for "max_force_N", "N m-1" for "stiffness_N_m", "degree" for "field_of_view_deg",
/// and "m" for "start_m_1", one number of a list. "1" where the name has no unit.
std::string summaryUnit(const std::string& name);

/// The name without its unit: "max_force" for "max_force_N", "start_1" for "start_m_1".
std::string withoutUnit(const std::string& name);

}  // namespace fissure
