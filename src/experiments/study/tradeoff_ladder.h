#pragma once

#include <limits>
#include <span>
#include <string>

namespace fissure {

/// Below this observed order a ladder of refinement counts as not converging: its differences hardly fall.
inline constexpr double least_order = 0.5;
/// Roache's factor of safety for grids of three sizes, on the error that the observed order gives.
inline constexpr double ladder_safety = 1.25;
/// An observed order above this is not believed when the error is estimated from it.
inline constexpr double most_order = 2;

/// What a ladder of refinement says of its finest rung.
struct Refinement {
  std::string refused;  ///< why its finest rung is no reference; empty: it is one
  /// Observed order; NaN where all rungs are the same, or the order is beyond -20 to 20.
  double order = std::numeric_limits<double>::quiet_NaN();
  /// Estimated error of the finest rung, with the factor of safety, in the unit of the differences.
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// The order p for which neighbouring rungs of sizes h differ as h^p does: from the last three sizes, which
/// fall, and the two differences between their rungs. Infinite where the finer difference is 0.
double observedOrder(std::span<const double> sizes, std::span<const double> differences);

/// Judges a ladder. `sizes`: of its rungs, at least three, falling; `differences`: between neighbours, one
/// fewer, from the coarsest on, none negative (norms of differences of curves, or of values). Differences of
/// at most `negligible` count as none. `unit` is for the reason alone.
Refinement refinementOf(std::span<const double> sizes, std::span<const double> differences, double negligible,
                        const std::string& unit);

/// Richardson's estimate of the value at size 0 from two rungs of sizes h and smaller, given the order.
double richardson(double coarse, double fine, double coarse_size, double fine_size, double order);

}  // namespace fissure
