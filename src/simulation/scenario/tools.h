#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "scenario/clamps.h"
#include "scenario/motions.h"
#include "scenario/shapes.h"

namespace fissure {

/// A rule that says where nodes stand on a tool.
enum class NodePlacement {
  grid,       ///< on both large faces of a box, facing nodes are partners (Fukuhara)
  centroids,  ///< one in each triangle, its partner in the triangle behind it
};

/// Where a tool's nodes stand, for the pipelines that use nodes.
struct NodeSettings {
  std::optional<NodePlacement> placement;  ///< default: grid for a box, centroids for every other shape
  /// Grid: nodes along the longer and the shorter edge of each large face, 1..512.
  std::array<int, 2> resolution = {8, 8};
  /// Grid, beyond the paper: rows of nodes on each narrow face too, 0 (none) to 512, so that a blade meets
  /// tissue edge first; along a row as many as on a large face.
  int narrow_rows = 0;
  /// Centroids: triangles are split for the placement of nodes until no edge is longer, > 0; default: as they
  /// are.
  std::optional<double> max_spacing_m;
  /// Centroids: the longest pairing ray, in thicknesses of the tool where it runs, > 0. Triangles whose ray
  /// is longer look along a thin tool, not across it.
  double pairing_limit = 3.0;
  /// Centroids: such triangles have nodes all the same, without partners.
  bool lone_nodes = false;
  /// Centroids: nodes also on the rim of the triangles that have them. Beyond the paper.
  bool rim_nodes = true;

  /// Of a grid.
  double gridCount() const {
    return 2.0 * resolution[0] * resolution[1] + 2.0 * narrow_rows * (resolution[0] + resolution[1]);
  }

  bool operator==(const NodeSettings&) const = default;
};

/// A tool of its own mass, which a hand leads by a spring and a damper (virtual coupling): its motion says
/// where the hand is. What tissue does to it then moves it too; gravity does not.
struct CouplingSettings {
  double mass_kg = 0;        ///< > 0; no default, as the next two
  double stiffness_N_m = 0;  ///< > 0
  double damping_N_s_m = 0;  ///< >= 0
  /// What tissue does to the tool: the name of an entry of `force:`, whose force of the step before moves it
  /// in steps of a micronewton, without what contacts rub; or `reaction`: the contacts themselves move it as
  /// they move the tissue, so that what the tool gains the tissue loses.
  std::string force;

  bool isPushedByContacts() const { return force == "reaction"; }

  bool operator==(const CouplingSettings&) const = default;
};

/// A rigid tool on a prescribed path, or led along one by a coupling; with `clamp` two of them, the jaws
/// NAME_left and NAME_right.
struct ToolSettings {
  std::string name;
  SurfaceShape shape = BoxShape{};  ///< in the tool's frame
  bool mirrored = false;            ///< the shape's mirror image in x = 0; rigidTools alone says so
  std::optional<ClampSettings> clamp;
  NodeSettings nodes;
  /// Coulomb's coefficient, >= 0, times the body's `solver.dynamic_friction` (pipeline cluster: the smaller
  /// of the two). Ray casting needs response momentum for it; to `prescribed` tissue sticks in any case.
  double friction = 0.0;
  /// The largest force of the haptic device that the tool stands for, > 0 (Falcon: 8 N by CHAI3D's
  /// specification). Forces beyond it are recorded as they are, with a flag. Default: no device.
  std::optional<double> force_limit_N;
  std::optional<CouplingSettings> coupling;  ///< default: none, the tool is where its motion says
  ToolMotion motion;

  NodePlacement nodePlacement() const {
    const bool box = std::holds_alternative<BoxShape>(shape);
    return nodes.placement.value_or(box ? NodePlacement::grid : NodePlacement::centroids);
  }

  bool operator==(const ToolSettings&) const = default;
};

}  // namespace fissure
