#pragma once

#include <array>
#include <optional>

#include "scenario/catalog.h"
#include "scenario/key.h"

namespace fissure {

/// A rule that says where nodes stand on a tool.
enum class NodePlacement {
  grid,       ///< grids on both large faces of a box; facing nodes are partners (Fukuhara)
  centroids,  ///< one node per triangle, its partner on the triangle across the tool
};

/// The placement of a tool's nodes, for the pipelines that use nodes (contact/METHOD.md 2). Narrow rows and
/// nodes on rims are not in the paper.
struct NodeSettings {
  std::optional<NodePlacement> placement;
  std::array<int, 2> resolution = {8, 8};
  int narrow_rows = 0;
  std::optional<double> max_spacing_m;
  double pairing_limit = 3.0;
  bool lone_nodes = false;
  bool rim_nodes = true;

  /// Number of nodes of placement `grid`.
  double gridCount() const {
    return 2.0 * resolution[0] * resolution[1] + 2.0 * narrow_rows * (resolution[0] + resolution[1]);
  }

  bool operator==(const NodeSettings&) const = default;
};

template <class Io>
void describe(Io& io, NodeSettings& n) {
  io.field("placement", n.placement,
           Key("Rule that says where the nodes stand.")
               .oneOf(catalog().node_placements)
               .otherwise("grid for a box, centroids for every other shape"));
  const bool grid = n.placement == NodePlacement::grid;
  const char *const of_grid = "placement grid", *const of_centroids = "placement centroids";
  io.field("resolution", n.resolution,
           Key("Nodes along the longer and along the shorter edge of each large face of a box.")
               .count(1, 512)
               .onlyIf(grid, of_grid));
  io.field("narrow_rows", n.narrow_rows,
           Key("Rows of nodes on each narrow face of a box too, each of as many nodes as along a large face, "
               "so that a blade can meet tissue edge first.")
               .count(0, 512)
               .onlyIf(grid, of_grid));
  io.field("max_spacing_m", n.max_spacing_m,
           Key("Triangles are split, for the placement of nodes alone, until no edge is longer.")
               .above(0)
               .otherwise("triangles as they are")
               .onlyIf(!grid, of_centroids));
  io.field("pairing_limit", n.pairing_limit,
           Key("Longest ray between partners, in thicknesses of the tool where it runs. Triangles whose ray "
               "is longer look along a thin tool, not across it, and have no node.")
               .noUnit()
               .above(0)
               .onlyIf(!grid, of_centroids));
  io.field("lone_nodes", n.lone_nodes,
           Key("Whether triangles beyond `pairing_limit` have nodes all the same, without partners.")
               .onlyIf(!grid, of_centroids));
  io.field("rim_nodes", n.rim_nodes,
           Key("Whether nodes also stand on the rim of the triangles that have them.")
               .onlyIf(!grid, of_centroids));
}

}  // namespace fissure
