#pragma once

#include <cstddef>
#include <vector>

namespace fissure {

/// Points of a series that a plot needs, ascending rows. What is not finite is missing (NaN).
struct ThinnedSeries {
  std::vector<std::size_t> rows;
  std::vector<double> values;
};

/// Thins out a series for a plot that shows `buckets` spans of equally many rows side by side: each span
/// keeps its smallest and its largest value, both at their own rows, and a missing value where it has any, so
/// that a spike or a gap of one row stays visible. The first and the last row are kept, and so is everything
/// where there are at most 2 rows a span. Of three and more equal values in succession the inner ones are
/// dropped, which changes no line. `buckets` > 0.
ThinnedSeries thinSeries(const std::vector<double>& values, std::size_t buckets);

/// The rows that the spans keep, before equal ones are dropped.
std::vector<std::size_t> extremeRows(const std::vector<double>& values, std::size_t buckets);

}  // namespace fissure
