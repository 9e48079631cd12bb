#pragma once

#include <string>

namespace fissure {

/// The unit that the name of a summary value carries: "max_force_N" "N", "first_contact_time_s" "s"; "1"
/// where it carries none.
std::string summaryUnit(const std::string& name);

/// A value for people, four digits and an SI prefix where its unit takes one: 0.02302 m "23.02 mm", 0 "0 m".
std::string withUnit(double value, const std::string& unit);

}  // namespace fissure
