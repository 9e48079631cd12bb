#include "text/units.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>

namespace fissure {

namespace {

struct Prefix {
  double factor;
  const char* text;
};
constexpr std::array<Prefix, 6> prefixes = {
    {{1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}, {1e-12, "p"}}};

bool takesPrefix(const std::string& unit) {
  return unit == "m" || unit == "N" || unit == "s" || unit == "J" || unit == "Hz" || unit == "N s" ||
         unit == "m s-1";
}

}  // namespace

std::string fourDigits(double value) {
  std::array<char, 32> text = {};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
  return {text.data(), end};
}

std::string withUnit(double value, const std::string& unit) {
  const std::string shown = unit == "1" || unit.empty() ? "" : " " + unit;
  const double size = std::abs(value);
  if (!takesPrefix(unit) || size == 0 || !std::isfinite(value) || size >= 1e6 || size < 1e-13)
    return fourDigits(value) + shown;
  // 999.96 rounds to 1000: the next prefix up is looked for with what four digits leave.
  for (const Prefix& prefix : prefixes)
    if (size >= 0.99995 * prefix.factor || prefix.factor < 2e-12)
      return fourDigits(value / prefix.factor) + " " + prefix.text + unit;
  return fourDigits(value) + shown;
}

std::string numberText(const char* pattern, double value) {
  return std::isnan(value) ? "nan" : fmt::format(fmt::runtime(pattern), value);
}

std::string timeText(double seconds) {
  if (seconds < 0.995) return fmt::format("{:.2f} s", seconds);
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  const long minutes = std::lround(seconds / 60);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

}  // namespace fissure
