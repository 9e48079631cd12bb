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
  bool moves = true;  ///< false: the same at all times, those of step 0
  /// Point by point, at the snapshot of that number.
  std::function<std::vector<double>(std::size_t snapshot)> values = {};
};

/// Triangles, or single points, that move and keep their topology.
struct MovingMesh {
  std::string name;  ///< "tissue", "tools", "nodes"
  std::size_t points = 0;
  std::vector<std::int64_t> corners;  ///< three a triangle; empty: the points alone
  PointArray positions_m;             ///< named Points, three components
  std::vector<PointArray> arrays;
};

/// What a viewer can show of a run: its meshes at the times of its snapshots.
struct MovingMeshes {
  std::vector<double> times_s;
  /// tissue (displacement since the first snapshot, vertex_contact, body); where there are any: tools, moved
  /// to where they were (tool); where a snapshot knows them: nodes of the tools, moved (node_state, tool).
  std::vector<MovingMesh> meshes;
};

/// Reads from `run` when asked for values, so it must not outlive it. A snapshot after the last recorded
/// step, as a salvaged run may have, is left out. No time: the run has no snapshots. Throws InputError.
MovingMeshes movingMeshes(const RunReader& run);

}  // namespace fissure
