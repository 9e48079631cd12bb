#pragma once

#include <string>

namespace fissure {

/// A value for people, with four digits: 0.02302, 1.234e+07.
std::string fourDigits(double value);

/// A value for people, four digits and an SI prefix where its unit takes one: 0.02302 m "23.02 mm", 0 "0 m".
std::string withUnit(double value, const std::string& unit);

}  // namespace fissure
