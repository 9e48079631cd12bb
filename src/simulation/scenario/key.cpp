#include "scenario/key.h"

#include <cmath>

#include "text/scalars.h"

namespace fissure {

namespace {

/// Limits that are whole numbers without an exponent, as people write counts.
std::string limitText(double value) {
  const bool is_count = std::abs(value) < 1e9 && value == std::round(value);
  return is_count ? std::to_string(std::lround(value)) : formatReal(value);
}

}  // namespace

bool Range::holds(double value) const {
  if (zero_too && value == 0) return true;
  return std::isfinite(value) && value <= most && (least_is_outside ? value > least : value >= least);
}

bool Range::isLimited() const {
  return std::isfinite(least) || std::isfinite(most);
}

std::string Range::expected() const {
  if (least == most) return limitText(least);
  const std::string because = reason.empty() ? "" : ": " + reason;
  if (zero_too) return "0 (" + reason + ") or " + limitText(least) + " to " + limitText(most);
  if (std::isfinite(most) && !least_is_outside)
    return "a number from " + limitText(least) + " to " + limitText(most) + because;
  if (!std::isfinite(least)) return "a finite number";
  const std::string limit =
      (least_is_outside ? "a number above " : "a number of at least ") + limitText(least);
  return limit + (std::isfinite(most) ? " and at most " + limitText(most) : "") + because;
}

}  // namespace fissure
