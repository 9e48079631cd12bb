#pragma once

#include <string>

namespace fissure {

/// A value with four significant digits, for people: 0.02302, 1.234e+07.
std::string fourDigits(double value);

/// A value with four significant digits and its unit, for people, with an SI prefix where the unit takes one:
/// "23.02 mm" for 0.02302 m, "0 m" for 0 m.
std::string withUnit(double value, const std::string& unit);

/// A value for people in the form that a pattern of fmt with one place asks for, 0.023 for "{:.3f}"; "nan"
/// without a sign.
std::string numberText(const char* pattern, double value);

/// A duration for people, rounded to about 2 %: "0.34 s", "4.2 s", "13 s", "2 min 10 s", "1 h 5 min".
std::string timeText(double seconds);

}  // namespace fissure
