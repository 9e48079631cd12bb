#pragma once

#include <cstddef>
#include <vector>

namespace fissure {

/// The points of a series that a plot needs, in ascending rows. Values that are not finite become NaN
/// (missing).
struct ThinnedSeries {
  std::vector<std::size_t> rows;
  std::vector<double> values;
};

/// Thins out a series for a plot. The rows are divided into `buckets` spans of equal length; each keeps its
/// smallest and its largest value, at their own rows, and one missing value if it has any, so that a spike or
/// a gap of a single row stays visible. The first and the last row are always kept, and all rows where there
/// are at most 2 per span. Of three or more equal values in succession the inner ones are dropped, which does
/// not change the line. `buckets` > 0.
ThinnedSeries thinSeries(const std::vector<double>& values, std::size_t buckets);

/// The rows that the spans keep, before equal values are dropped.
std::vector<std::size_t> extremeRows(const std::vector<double>& values, std::size_t buckets);

}  // namespace fissure
