#pragma once

#include <vector>

#include "base/tetrahedra.h"
#include "elastic/element_kernels.h"

namespace fissure {

/// The share of the elements of one material in a vertex. Their slots of the vertex are contiguous.
struct VertexShare {
  int vertex = 0;
  int first_slot = 0, end_slot = 0;
  double volume_m3 = 0;  ///< a quarter of the volume of these elements
};

/// The groups with the elements of one material; no group has elements of two.
struct MaterialLanes {
  int first_group = 0, groups = 0;
  std::vector<VertexShare> shares;  ///< of their vertices, ascending
};

/// Owns the arrays of ElementArrays, for a mesh at rest.
struct ElementLanes {
  /// `of_elements`: [tetrahedron] number of its material; empty: a single material. Throws
  /// std::invalid_argument, with one line, for corners that are no vertices, tetrahedra of no or negative
  /// volume, vertices that are not finite and vertices of no tetrahedron.
  explicit ElementLanes(const TetrahedralMesh& rest, const std::vector<int>& of_elements = {});

  ElementArrays view() const;
  ElementArrays viewOf(const MaterialLanes& material) const;  ///< only the groups of one material
  /// Number of slots that passes write to: one per corner, and one for the padding lanes of last groups.
  std::size_t slotCount() const { return slot_count; }

  int groups = 0;
  std::vector<MaterialLanes> materials;
  std::vector<int> corners, slots, first_slots;
  std::vector<double> inverse_edges, metrics, volumes_m3;
  std::vector<double> vertex_volumes_m3;  ///< [vertex] a quarter of the volume of its elements
  std::size_t slot_count = 0;

 private:
  /// Appends the groups of the elements of one material; `next`: [vertex] its next free slot.
  void append(const TetrahedralMesh& rest, const std::vector<std::size_t>& elements, std::vector<int>& next);
};

}  // namespace fissure
