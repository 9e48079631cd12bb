#pragma once

#include <optional>
#include <vector>

#include "base/scene.h"

namespace fissure {

/// Points on a tool's surface on which penetration is measured, in the tool's frame.
struct ToolSamples {
  std::vector<Vec3> points_m;
  /// Largest distance of any point of the surface from its nearest sample, a bound of the error of a depth.
  double coverage_m = 0;
};

/// Largest number of samples of a tool: without a spacing in the scenario, and with one.
inline constexpr long long kDefaultSampleLimit = 20'000;
inline constexpr long long kStatedSampleLimit = 2'000'000;

/// Samples over all faces of a tool, narrow ones included, at most `spacing_m` apart along the edges of a
/// face, and close to every edge and corner of a box, where a tool is deepest (measure/METHOD.md 1). A
/// triangle is cut into cells, as many as its area needs, however long and thin it is, with one sample in
/// each. Without a value the spacing is the smaller of 3/8 of the tool's thickness (its least extent) and a
/// third of the shortest edge of any body at rest, widened until there are at most kDefaultSampleLimit
/// samples. Samples depend only on the tool's surface and the bodies, and so are the same for every pipeline.
/// They lie at irrational fractions of a face, nodes at rational ones (grids, centroids), so the two never
/// coincide. Throws InputError when a stated spacing needs more than kStatedSampleLimit samples.
ToolSamples makeToolSamples(const Scene& scene, const SceneTool& tool, std::optional<double> spacing_m);

}  // namespace fissure
