#include "measure/sample_clusters.h"

#include <algorithm>
#include <span>

namespace fissure {

namespace {

/// More make a bound too coarse, fewer make too many bounds.
constexpr std::size_t most_samples = 16;

/// Halves the points across the longest edge of their box until the halves are small enough.
void split(std::span<Vec3> points_m, std::size_t first, std::vector<SampleCluster>& clusters) {
  Vec3 low = points_m.front(), high = low;
  for (const Vec3& point : points_m) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  if (points_m.size() <= most_samples) {
    clusters.push_back({first, points_m.size(), (low + high) / 2, (high - low) / 2});
    return;
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t half = points_m.size() / 2;
  std::nth_element(points_m.begin(), points_m.begin() + static_cast<std::ptrdiff_t>(half), points_m.end(),
                   [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  split(points_m.first(half), first, clusters);
  split(points_m.subspan(half), first + half, clusters);
}

}  // namespace

std::vector<SampleCluster> clusterSamples(std::vector<Vec3>& points_m) {
  std::vector<SampleCluster> clusters;
  split(points_m, 0, clusters);
  return clusters;
}

}  // namespace fissure
