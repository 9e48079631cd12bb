#include "measure/same_triangles_roughness.h"

#include <algorithm>
#include <cmath>

#include "measure/statistics.h"

namespace fissure {

void SameTrianglesRoughness::add(const State& state) {
  std::rotate(steps_.begin(), steps_.end() - 1, steps_.end());
  steps_[0].triangles = state.colliding_triangles;
  steps_[0].forces_N = state.triangle_forces_N;
  ++count_;
  for (std::size_t law = 0; law < sums_.size(); ++law)
    sums_[law].force_squared += state.forces[law].force_on_tool_N.squaredNorm();
  if (count_ < 3) return;
  for (Sums& sums : sums_) sums.shared_N.fill(Vec3::Zero());
  addShared();
  for (Sums& sums : sums_) {
    const auto& [now_N, last_N, before_N] = sums.shared_N;
    const double difference_N = before_N.norm() - 2 * last_N.norm() + now_N.norm();
    sums.difference_squared += difference_N * difference_N;
  }
}

// One walk through three ascending lists.
void SameTrianglesRoughness::addShared() {
  std::array<std::size_t, 3> at{};
  for (const int triangle : steps_[0].triangles) {
    bool in_all = true;
    for (std::size_t s = 1; s < 3; ++s) {
      const std::vector<int>& triangles = steps_[s].triangles;
      while (at[s] < triangles.size() && triangles[at[s]] < triangle) ++at[s];
      in_all &= at[s] < triangles.size() && triangles[at[s]] == triangle;
    }
    for (std::size_t law = 0; in_all && law < sums_.size(); ++law)
      for (std::size_t s = 0; s < 3; ++s)
        sums_[law].shared_N[s] += steps_[s].forces_N[at[s] * sums_.size() + law];
    ++at[0];
  }
}

double SameTrianglesRoughness::value(std::size_t law) const {
  const Sums& sums = sums_[law];
  if (count_ < 3 || sums.force_squared == 0) return kMissing;
  const double mean_square = sums.force_squared / static_cast<double>(count_);
  return std::sqrt(sums.difference_squared / static_cast<double>(count_ - 2) / mean_square);
}

}  // namespace fissure
