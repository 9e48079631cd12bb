#pragma once

#include <cstddef>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Neighbouring samples of a tool, with a box around them in the tool's frame.
struct SampleCluster {
  std::size_t first = 0, count = 0;  ///< of the samples
  Vec3 centre_m = Vec3::Zero();
  Vec3 half_m = Vec3::Zero();  ///< half the edges of the box
};

/// Puts samples that lie together next to each other and groups them: a bound of the distance of a group's
/// box from a surface is a bound for each of its samples. At least one sample; each is in exactly one group.
std::vector<SampleCluster> clusterSamples(std::vector<Vec3>& points_m);

}  // namespace fissure
