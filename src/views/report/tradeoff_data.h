#pragma once

#include <vector>

#include "report/report_run.h"

namespace fissure {

/// What the page of a study of accuracy and cost shows, of the contents of tradeoff.json: quantities with
/// their references and their front, settings with an error each quantity, orders, answers. Throws
/// InputError, without a file, for what `fissure study tradeoff` does not write.
PageJson tradeoffData(const PageJson& study);

/// A setting in a plot of one quantity.
struct FrontPoint {
  double cost = 0;
  double error = 0;
};

/// Indices of the points that no cheaper or as cheap one beats, from the cheapest on. Errors that differ by
/// less than 1 % count as the same, as they do where settings are recommended.
std::vector<std::size_t> frontOf(const std::vector<FrontPoint>& points);

}  // namespace fissure
