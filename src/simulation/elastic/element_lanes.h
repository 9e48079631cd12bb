#pragma once

#include <vector>

#include "base/tetrahedra.h"
#include "elastic/element_kernels.h"

namespace fissure {

/// The arrays that ElementArrays points to, for a mesh at rest.
struct ElementLanes {
  /// Throws std::invalid_argument, with one line, for corners that are no vertices, tetrahedra of no or
  /// negative volume, vertices that are not finite and vertices of no tetrahedron.
  explicit ElementLanes(const TetrahedralMesh& rest);

  ElementArrays view() const;
  /// Slots that passes write to: one per corner, and one for lanes that fill up the last group.
  std::size_t slotCount() const { return slot_count; }

  int groups = 0;
  std::vector<int> corners, slots, first_slots;
  std::vector<double> inverse_edges, metrics, volumes_m3;
  std::vector<double> vertex_volumes_m3;  ///< a quarter of what meets at each vertex
  std::size_t slot_count = 0;
};

}  // namespace fissure
