#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace fissure {

/// Errors that differ by less than this share count as the same: the cheaper setting is then the better one.
inline constexpr double same_error = 0.01;

/// Which of the settings are on the Pareto front: no other one is both at least as cheap and at least as
/// accurate, and better in one of the two. A cost or error that is not finite is never on it.
std::vector<bool> paretoFront(std::span<const double> costs, std::span<const double> errors);

/// A power law of errors over the size of a setting, in the least squares of logarithms.
struct ObservedOrder {
  double order = std::numeric_limits<double>::quiet_NaN();
  std::size_t values = 0;  ///< how many sizes it is from, at least three
};

/// How the error grows with a size. Sizes whose error is not finite, or below twice `floor`, the error of the
/// reference itself, say nothing and are left out; NaN where fewer than three are left.
ObservedOrder orderOf(std::span<const double> sizes, std::span<const double> errors, double floor);

/// A recommended setting.
struct Choice {
  std::optional<std::size_t> best;     ///< within all limits; no value: none is
  std::optional<std::size_t> nearest;  ///< where there is no best: the one that needs the least more
  double times_over = std::numeric_limits<double>::quiet_NaN();  ///< by what factor the nearest is beyond
};

/// The most accurate setting of at most this cost; of those as accurate the cheapest. Where none is, the
/// cheapest.
Choice mostAccurate(std::span<const double> costs, std::span<const double> errors, double budget);

/// The cheapest setting whose `excess`, the largest of its errors over their limits, is at most 1; among
/// equals the most accurate. Where none is, the one of the smallest excess.
Choice cheapest(std::span<const double> costs, std::span<const double> excess);

/// Median and quartiles of the values that are finite, linear between these; NaN where there is none.
struct Spread {
  double low = std::numeric_limits<double>::quiet_NaN();  ///< lower quartile
  double median = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();  ///< upper quartile
  std::size_t count = 0;
};

Spread spreadOf(std::vector<double> values);

}  // namespace fissure
