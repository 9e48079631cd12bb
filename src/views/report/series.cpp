#include "report/series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fissure {

namespace {

/// Appends the rows of [first, end) to keep, ascending.
void keepExtremes(const std::vector<double>& values, std::size_t first, std::size_t end,
                  std::vector<std::size_t>& rows) {
  std::size_t smallest = end, largest = end, missing = end;
  for (std::size_t row = first; row < end; ++row) {
    if (!std::isfinite(values[row])) {
      if (missing == end) missing = row;
      continue;
    }
    if (smallest == end || values[row] < values[smallest]) smallest = row;
    if (largest == end || values[row] > values[largest]) largest = row;
  }
  std::vector<std::size_t> kept = {smallest, largest, missing};
  std::sort(kept.begin(), kept.end());
  for (const std::size_t row : kept)
    if (row < end && (rows.empty() || row != rows.back())) rows.push_back(row);
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

std::vector<std::size_t> extremeRows(const std::vector<double>& values, std::size_t buckets) {
  std::vector<std::size_t> rows;
  if (values.size() <= 2 * buckets) {
    rows.resize(values.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return rows;
  }
  rows.push_back(0);
  for (std::size_t bucket = 0; bucket < buckets; ++bucket)
    keepExtremes(values, bucket * values.size() / buckets, (bucket + 1) * values.size() / buckets, rows);
  if (rows.back() != values.size() - 1) rows.push_back(values.size() - 1);
  return rows;
}

ThinnedSeries thinSeries(const std::vector<double>& values, std::size_t buckets) {
  ThinnedSeries thinned;
  for (const std::size_t row : extremeRows(values, buckets)) {
    const double value = std::isfinite(values[row]) ? values[row] : std::numeric_limits<double>::quiet_NaN();
    const std::size_t count = thinned.rows.size();
    if (count > 1 && same(value, thinned.values[count - 1]) && same(value, thinned.values[count - 2])) {
      thinned.rows.back() = row;
      continue;
    }
    thinned.rows.push_back(row);
    thinned.values.push_back(value);
  }
  return thinned;
}

}  // namespace fissure
