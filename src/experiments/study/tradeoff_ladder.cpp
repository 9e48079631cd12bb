#include "study/tradeoff_ladder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "measure/statistics.h"
#include "text/units.h"

namespace fissure {

namespace {

constexpr double widest_order = 20;

/// The ratio of the coarser to the finer of two neighbouring differences for this order: it rises with it.
double ratioFor(double order, double coarse, double middle, double fine) {
  if (std::abs(order) < 1e-9) return std::log(coarse / middle) / std::log(middle / fine);
  return (std::pow(coarse / middle, order) - 1) / (1 - std::pow(fine / middle, order));
}

std::string differencesText(std::span<const double> values, const std::string& unit) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + withUnit(value, unit);
  return text;
}

}  // namespace

double observedOrder(std::span<const double> sizes, std::span<const double> differences) {
  if (sizes.size() < 3 || differences.size() + 1 != sizes.size())
    throw std::logic_error("a ladder needs three sizes, and a difference between each two");
  const double coarse = sizes[sizes.size() - 3], middle = sizes[sizes.size() - 2], fine = sizes.back();
  const double before = differences[differences.size() - 2], last = differences.back();
  if (!std::isfinite(before) || !std::isfinite(last)) return kMissing;
  if (last == 0) return before == 0 ? kMissing : std::numeric_limits<double>::infinity();
  const double ratio = before / last;
  double low = -widest_order, high = widest_order;
  if (ratio < ratioFor(low, coarse, middle, fine) || ratio > ratioFor(high, coarse, middle, fine))
    return kMissing;
  for (int i = 0; i < 200; ++i) {
    const double order = 0.5 * (low + high);
    (ratioFor(order, coarse, middle, fine) < ratio ? low : high) = order;
  }
  return 0.5 * (low + high);
}

Refinement refinementOf(std::span<const double> sizes, std::span<const double> differences, double negligible,
                        const std::string& unit) {
  Refinement found;
  found.order = observedOrder(sizes, differences);
  const double before = differences[differences.size() - 2], last = differences.back();
  if (!std::isfinite(before) || !std::isfinite(last)) {
    found.refused = "a rung of the ladder has no value";
    return found;
  }
  if (std::max(before, last) <= negligible) {
    found.error = std::max(before, last);
    found.order = kMissing;
    return found;
  }
  const double factor = sizes[sizes.size() - 2] / sizes.back();
  const bool falls = last < before && !(found.order < least_order);
  if (!falls) {
    found.refused =
        fmt::format("does not converge: its rungs differ by {}{}", differencesText(differences, unit),
                    std::isnan(found.order) ? std::string() : fmt::format(", order {:.2f}", found.order));
    return found;
  }
  const double order = std::isnan(found.order) ? most_order : std::min(found.order, most_order);
  found.error = ladder_safety * last / (std::pow(factor, order) - 1);
  return found;
}

double richardson(double coarse, double fine, double coarse_size, double fine_size, double order) {
  return fine + (fine - coarse) / (std::pow(coarse_size / fine_size, order) - 1);
}

}  // namespace fissure
