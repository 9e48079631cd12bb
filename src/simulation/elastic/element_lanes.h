#pragma once

#include <vector>

#include "base/tetrahedra.h"
#include "elastic/element_kernels.h"

namespace fissure {

/// What the elements of one material have of a vertex. Their slots of it stand one after another.
struct VertexShare {
  int vertex = 0;
  int first_slot = 0, end_slot = 0;
  double volume_m3 = 0;  ///< a quarter of theirs
};

/// The groups of the elements of one material: none is shared with another.
struct MaterialLanes {
  int first_group = 0, groups = 0;
  std::vector<VertexShare> shares;  ///< of the vertices they have, ascending
};

/// The arrays that ElementArrays points to, for a mesh at rest.
struct ElementLanes {
  /// `of_elements`: one a tetrahedron, the number of its material; empty: all have one. Throws
  /// std::invalid_argument, with one line, for corners that are no vertices, tetrahedra of no or negative
  /// volume, vertices that are not finite and vertices of no tetrahedron.
  explicit ElementLanes(const TetrahedralMesh& rest, const std::vector<int>& of_elements = {});

  ElementArrays view() const;
  ElementArrays viewOf(const MaterialLanes& material) const;  ///< its groups alone
  /// Slots that passes write to: one per corner, and one for lanes that fill up a last group.
  std::size_t slotCount() const { return slot_count; }

  int groups = 0;
  std::vector<MaterialLanes> materials;
  std::vector<int> corners, slots, first_slots;
  std::vector<double> inverse_edges, metrics, volumes_m3;
  std::vector<double> vertex_volumes_m3;  ///< a quarter of what meets at each vertex
  std::size_t slot_count = 0;

 private:
  /// Appends the groups of the elements of one material; `next`: of each vertex, its next free slot.
  void append(const TetrahedralMesh& rest, const std::vector<std::size_t>& elements, std::vector<int>& next);
};

}  // namespace fissure
