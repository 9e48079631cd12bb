#pragma once

#include <vector>

#include "base/geometry.h"

namespace fissure {

/// [triangle] the number of its shell, a connected piece that shares no vertex with others; shells are
/// numbered from 0 in the order of their first triangles. All indices must be valid.
std::vector<int> shellsOf(const TriangleMesh& mesh);

/// The triangles of each shell, in the order of shellsOf.
std::vector<std::vector<Face>> splitShells(const TriangleMesh& mesh);

/// Finds out which of several closed surfaces lie inside others. `mesh` and `surfaces` (lists of its faces)
/// must outlive this object.
class Nesting {
 public:
  Nesting(const TriangleMesh& mesh, const std::vector<std::vector<Face>>& surfaces);
  /// Number of other surfaces that enclose surface `index`, whatever their orientation: the winding number of
  /// its first corner (van Oosterom and Strackee 1983).
  int depth(std::size_t index) const;

 private:
  const TriangleMesh& mesh_;
  const std::vector<std::vector<Face>>& surfaces_;
  std::vector<Eigen::AlignedBox3d> bounds_;
};

/// Volume that `faces` of the mesh, a closed outward surface, enclose, by the divergence theorem, in the cube
/// of the vertices' unit; negative when inside out.
double signedVolume(const TriangleMesh& mesh, const std::vector<Face>& faces);

}  // namespace fissure
