#pragma once

#include <optional>
#include <string>

#include "base/scene.h"

namespace fissure {

/// The spacing of a tool's nodes compared with the mesh of the tissue (measure/METHOD.md 4).
struct NodeSpacing {
  std::string tool, body;
  /// Spacing of a square grid with equally large gaps, metres: the square root of 2 times the largest
  /// distance of any point of the tool's surface from its nearest node.
  double spacing_m = 0;
  double edge_m = 0;  ///< mean edge length of the body at rest

  double ratio() const { return spacing_m / edge_m; }
};

/// The ratio above which tissue gets in between nodes.
inline constexpr double kWideNodes = 0.5;

/// The spacing of the tool with the widest gaps, compared with the body with the shortest edges; no value
/// without nodes.
std::optional<NodeSpacing> widestNodeSpacing(const Scene& scene);

/// A warning about wide spacing: "nodes are up to 5.1 mm apart, 0.7 of a mean tissue edge: ...".
std::string wideNodesText(double spacing_m, double ratio);

/// Whether a displacement in a box's frame deviates by more than 10 degrees from each of the box's axes.
/// Where nodes stand on all sides of the box, nodes of two sides then act on the same tissue and tear it.
bool isOblique(const Vec3& way_in_tool);

}  // namespace fissure
