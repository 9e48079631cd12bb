#pragma once

#include <optional>
#include <vector>

#include "base/scene.h"

namespace fissure {

/// Points on a tool's surface on which penetration is measured, in the tool's frame.
struct ToolSamples {
  std::vector<Vec3> points_m;
  double coverage_m =
      0;  ///< no point of the surface is farther from the nearest sample: bounds the error of a depth
};

/// The most samples a tool gets when the scenario leaves the spacing open, and when it states it.
inline constexpr long long kDefaultSampleLimit = 20'000;
inline constexpr long long kStatedSampleLimit = 2'000'000;

/// Samples over all faces of a tool, narrow ones included, at most `spacing_m` apart along a face's edges,
/// and close to every edge and corner of a box, where a tool is deepest. A face of triangles has one in each
/// of the cells into which it is cut: as many as its area asks for, however long and thin its triangles are.
/// No value: the smaller of 3/8 of the tool's thickness (its least extent) and a third of the shortest edge
/// of any body at rest, widened until kDefaultSampleLimit is kept. They depend on the tool's surface and the
/// bodies alone, so they are the same for every pipeline. Samples sit at irrational fractions of a face,
/// nodes at rational ones (grids, centroids): they never coincide. Throws InputError when a stated spacing
/// needs more than kStatedSampleLimit samples.
ToolSamples makeToolSamples(const Scene& scene, const SceneTool& tool, std::optional<double> spacing_m);

}  // namespace fissure
