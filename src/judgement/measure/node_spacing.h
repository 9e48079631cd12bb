#pragma once

#include <optional>
#include <string>

#include "base/scene.h"

namespace fissure {

/// How far apart a tool's nodes are, against the tissue that has to rest on them.
struct NodeSpacing {
  std::string tool, body;
  /// Of a square grid that leaves as large a gap on the tool's surface: the square root of 2 times the
  /// farthest that any point of the surface is from its nearest node, metres.
  double spacing_m = 0;
  double edge_m = 0;  ///< mean edge of the body at rest

  double ratio() const { return spacing_m / edge_m; }
};

/// Above this ratio tissue gets in between nodes.
inline constexpr double kWideNodes = 0.5;

/// The widest of all tools with nodes, against the body of the shortest edges; no value without nodes.
std::optional<NodeSpacing> widestNodeSpacing(const Scene& scene);

/// What wide nodes mean: "nodes are up to 5.1 mm apart, 0.7 of a mean tissue edge: ...".
std::string wideNodesText(double spacing_m, double ratio);

/// Whether a way in a box's frame is more than 10 degrees off each of the box's axes: where nodes stand on
/// all of its sides, those of two sides then take hold of the same tissue and tear it.
bool isOblique(const Vec3& way_in_tool);

}  // namespace fissure
