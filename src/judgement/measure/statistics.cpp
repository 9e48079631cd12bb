#include "measure/statistics.h"

#include <algorithm>
#include <cmath>

namespace fissure {

RecordAxis xyzAxis() {
  return {"xyz", {"x", "y", "z"}};
}

void writeVector(const Vec3& vector, std::size_t first_column, RecordRow& row) {
  for (int i = 0; i < 3; ++i) row[first_column + static_cast<std::size_t>(i)] = vector[i];
}

SummaryValue countOrMissing(const std::string& name, bool counted, long long count) {
  if (!counted) return {name, kMissing};
  return {name, count};
}

double Roughness::of(std::span<const Roughness> series) {
  double mean_square = 0, mean_square_difference = 0;
  for (const Roughness& one : series) {
    if (one.count_ < 3) return kMissing;
    mean_square += one.sum_of_squares_ / static_cast<double>(one.count_);
    mean_square_difference += one.sum_of_squared_differences_ / static_cast<double>(one.count_ - 2);
  }
  return mean_square == 0 ? kMissing : std::sqrt(mean_square_difference / mean_square);
}

double percentile(std::vector<double> values, double percent) {
  if (values.empty()) return kMissing;
  const double rank = std::ceil(percent / 100 * static_cast<double>(values.size()));
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace fissure
