#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/record.h"
#include "store/run_reader.h"

namespace fissure {

/// A quantity at the points of a MovingMesh.
struct PointArray {
  std::string name;
  ValueType type = ValueType::real;
  std::size_t components = 1;
  bool moves = true;  ///< false: constant, with the values of snapshot 0
  /// Returns the values at a snapshot, point by point.
  std::function<std::vector<double>(std::size_t snapshot)> values = {};
};

/// A moving mesh of triangles or of points, with constant topology.
struct MovingMesh {
  std::string name;  ///< "tissue", "tools", "nodes"
  std::size_t points = 0;
  std::vector<std::int64_t> corners;  ///< three per triangle; empty: points only
  PointArray positions_m;             ///< named Points, three components, scene frame
  std::vector<PointArray> arrays;
};

/// The meshes of a run at the times of its snapshots, for a viewer.
struct MovingMeshes {
  std::vector<double> times_s;
  /// Up to three meshes, with their arrays in brackets: tissue (displacement since the first snapshot,
  /// vertex_contact, body); tools at their poses, where there are tools (tool); and nodes of the tools, where
  /// snapshots have node states (node_state, tool).
  std::vector<MovingMesh> meshes;
};

/// The meshes of a run. They read from `run` when they are asked for values, and so must not outlive it. A
/// snapshot after the last recorded step, which a salvaged run may have, is left out. times_s is empty when
/// the run has no snapshots. Throws InputError when the result is damaged.
MovingMeshes movingMeshes(const RunReader& run);

}  // namespace fissure
