#pragma once

#include <vector>

#include "base/geometry.h"

namespace fissure {

/// For each triangle the number of its shell, from 0 in the order of first triangles: shells share no vertex.
/// All vertices must exist.
std::vector<int> shellsOf(const TriangleMesh& mesh);

/// The triangles of each shell, numbered as shellsOf does.
std::vector<std::vector<Face>> splitShells(const TriangleMesh& mesh);

/// Which of several closed surfaces lie inside others. `mesh` and `surfaces`, faces of it, must outlive this.
class Nesting {
 public:
  Nesting(const TriangleMesh& mesh, const std::vector<std::vector<Face>>& surfaces);
  /// How many of the others enclose surface `index`, whichever way round they run, by its first corner
  /// (winding number: van Oosterom and Strackee 1983).
  int depth(std::size_t index) const;

 private:
  const TriangleMesh& mesh_;
  const std::vector<std::vector<Face>>& surfaces_;
  std::vector<Eigen::AlignedBox3d> bounds_;
};

/// Volume that `faces` of the mesh, closed and outward, enclose, by the divergence theorem; negative when
/// inside out. In the cube of the vertices' unit.
double signedVolume(const TriangleMesh& mesh, const std::vector<Face>& faces);

}  // namespace fissure
