#include "measure/node_spacing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/tool_samples.h"

namespace fissure {

namespace {

double meanEdge_m(const TriangleMesh& mesh) {
  double sum_m = 0;
  for (const Face& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i)
      sum_m += (mesh.vertices_m[static_cast<std::size_t>(face[i])] -
                mesh.vertices_m[static_cast<std::size_t>(face[(i + 1) % 3])])
                   .norm();
  return sum_m / static_cast<double>(3 * mesh.faces.size());
}

/// The farthest that a sample is from its nearest node. A sample is done with as soon as some node is nearer
/// than that, and the search goes on from there: neighbours are near the same nodes.
double largestGap_m(const std::vector<Vec3>& samples_m, const std::vector<Vec3>& nodes_m) {
  double gap_squared = 0;
  std::size_t start = 0;
  for (const Vec3& sample_m : samples_m) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < nodes_m.size() && nearest > gap_squared; ++k) {
      const std::size_t i = (start + k) % nodes_m.size();
      const double squared = (nodes_m[i] - sample_m).squaredNorm();
      if (!(squared < nearest)) continue;
      nearest = squared;
      if (nearest <= gap_squared) start = i;
    }
    gap_squared = std::max(gap_squared, nearest);
  }
  return std::sqrt(gap_squared);
}

}  // namespace

std::optional<NodeSpacing> widestNodeSpacing(const Scene& scene) {
  NodeSpacing widest;
  widest.edge_m = std::numeric_limits<double>::infinity();
  for (const SceneBody& body : scene.bodies) {
    const double edge_m = meanEdge_m(body.rest);
    if (!(edge_m < widest.edge_m)) continue;
    widest.edge_m = edge_m;
    widest.body = body.name;
  }
  for (const SceneTool& tool : scene.tools) {
    if (tool.nodes.size() == 0) continue;
    const double spacing_m =
        std::sqrt(2.0) *
        largestGap_m(makeToolSamples(scene, tool, std::nullopt).points_m, tool.nodes.positions_m);
    if (!(spacing_m > widest.spacing_m)) continue;
    widest.spacing_m = spacing_m;
    widest.tool = tool.name;
  }
  if (widest.tool.empty()) return std::nullopt;
  return widest;
}

bool isOblique(const Vec3& way_in_tool) {
  constexpr double kCosine = 0.985;  // of 10 degrees
  return way_in_tool.cwiseAbs().maxCoeff() < kCosine * way_in_tool.norm();
}

std::string wideNodesText(double spacing_m, double ratio) {
  return fmt::format(
      "nodes are up to {:.2g} mm apart, {:.2g} of a mean tissue edge: above {:.1g} tissue gets in between",
      1e3 * spacing_m, ratio, kWideNodes);
}

}  // namespace fissure
